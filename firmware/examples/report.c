#include "report.h"

#include "board.h"

void report_count(const char *what, uint32_t count)
{
    char text[11];
    char *digit = text + sizeof text - 1;
    *digit = '\0';
    do {
        *--digit = (char)('0' + count % 10U);
        count /= 10U;
    } while (count > 0);
    board_write(what);
    board_write(digit);
    board_write("\n");
}

/* The library's own operations alone, so that it is one code for all number types. */
static void write_number(twd_num number)
{
    char text[] = " +0.000";
    if (number < TWD_NUM(0)) {
        text[1] = '-';
        number = -number;
    }
    while (number >= TWD_NUM(1) && text[2] < '9') {
        number -= TWD_NUM(1);
        text[2]++;
    }
    for (size_t digit = 4; digit < 7; digit++) {
        /* Ten times the number as twice five times it, for a format that ends at 8. */
        number = twd_mul(number, TWD_NUM(5));
        while (number >= TWD_NUM(0.5)) {
            number -= TWD_NUM(0.5);
            text[digit]++;
        }
        number += number;
    }
    board_write(text);
}

void report_numbers(const char *what, const twd_num *number, size_t count)
{
    board_write(what);
    for (size_t i = 0; i < count; i++)
        write_number(number[i]);
    board_write("\n");
}

#if defined(TWD_NUMBER_FIXED)

void report_checksum(const char *what, uint32_t sum)
{
    char text[9];
    for (unsigned i = 0; i < 8; i++)
        text[i] = "0123456789ABCDEF"[(sum >> (28U - 4U * i)) & 15U];
    text[8] = '\0';
    board_write(what);
    board_write(text);
    board_write("\n");
}

uint32_t report_checksum_of(uint32_t sum, const twd_num *number, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        for (unsigned bits = 0; bits < 32; bits += 8) {
            sum ^= ((uint32_t)number[i] >> bits) & 0xFFU;
            sum *= UINT32_C(0x01000193);
        }
    }
    return sum;
}

#else

void report_checksum(const char *what, uint32_t sum)
{
    (void)what;
    (void)sum;
}

uint32_t report_checksum_of(uint32_t sum, const twd_num *number, size_t count)
{
    (void)number;
    (void)count;
    return sum;
}

#endif
