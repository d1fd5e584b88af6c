#include "seven.h"

#include "board.h"
#include "reference.h"

#include <math.h>

static double largest_error(void)
{
    double largest = 0;
    for (size_t i = 0; i < DRIVE_OSCILLATORS; i++)
        largest = fmax(largest, fabs(seven_output(i) - reference_output(i)));
    return largest;
}

/* Write `error`, below 4, in units of 1e-9. */
static void write_error(double error)
{
    char text[] = "error_1e-9 ..........\n";
    unsigned long units = (unsigned long)(error * 1e9 + 0.5);
    for (char *digit = text + sizeof text - 3; *digit == '.'; digit--) {
        *digit = (char)('0' + units % 10);
        units /= 10;
    }
    board_write(text);
}

void seven_run(void)
{
    double largest = 0;
    for (unsigned set = 0; set < DRIVE_SETS; set++) {
        double parameter[DRIVE_PARAMETERS];
        struct drive drive;
        drive_draw(set, parameter);
        drive_read(parameter, &drive);
        seven_start(parameter, &drive);
        reference_start(&drive);
        for (int tick = 0; tick < DRIVE_TICKS; tick++) {
            seven_tick();
            reference_tick();
            largest = fmax(largest, largest_error());
        }
    }
    write_error(largest);
}
