#include "agent/frame.h"

#include <stdbool.h>
#include <string.h>

#define FIRST_BYTE 0x54U
#define SECOND_BYTE 0x57U

uint32_t twd_crc32(const uint8_t *bytes, size_t count)
{
    /* Four bits at a time: a table of 64 bytes, where eight at a time would take 1 KiB of a small chip's flash. */
    static const uint32_t table[16] = {0x00000000U, 0x1DB71064U, 0x3B6E20C8U, 0x26D930ACU, 0x76DC4190U, 0x6B6B51F4U,
                                       0x4DB26158U, 0x5005713CU, 0xEDB88320U, 0xF00F9344U, 0xD6D6A3E8U, 0xCB61B38CU,
                                       0x9B64C2B0U, 0x86D3D2D4U, 0xA00AE278U, 0xBDBDF21CU};
    uint32_t crc = UINT32_MAX;
    for (size_t i = 0; i < count; i++) {
        crc ^= bytes[i];
        crc = (crc >> 4) ^ table[crc & 15U];
        crc = (crc >> 4) ^ table[crc & 15U];
    }
    return ~crc;
}

size_t twd_frame_encode(const struct twd_frame *frame, uint8_t *bytes)
{
    bytes[0] = FIRST_BYTE;
    bytes[1] = SECOND_BYTE;
    bytes[2] = frame->type;
    bytes[3] = frame->sequence;
    bytes[4] = (uint8_t)(frame->length & 0xFFU);
    bytes[5] = (uint8_t)(frame->length >> 8);
    memcpy(bytes + TWD_FRAME_HEADER, frame->payload, frame->length);

    const size_t before_crc = TWD_FRAME_HEADER + frame->length;
    const uint32_t crc = twd_crc32(bytes, before_crc);
    for (unsigned i = 0; i < TWD_FRAME_CRC; i++)
        bytes[before_crc + i] = (uint8_t)(crc >> (8U * i));
    return before_crc + TWD_FRAME_CRC;
}

uint8_t *twd_frame_reader_space(struct twd_frame_reader *reader, size_t *capacity)
{
    *capacity = TWD_FRAME_MAX_SIZE - reader->count;
    return reader->buffer + reader->count;
}

void twd_frame_reader_filled(struct twd_frame_reader *reader, size_t count)
{
    reader->count += count;
}

static void drop(struct twd_frame_reader *reader, size_t count)
{
    reader->count -= count;
    memmove(reader->buffer, reader->buffer + count, reader->count);
}

static size_t payload_length(const uint8_t *bytes)
{
    return (size_t)bytes[4] | (size_t)bytes[5] << 8;
}

/* Whether the bytes, as far as they have arrived, can be the start of a frame. */
static bool may_start_here(const uint8_t *bytes, size_t count)
{
    if (bytes[0] != FIRST_BYTE) return false;
    if (count > 1 && bytes[1] != SECOND_BYTE) return false;
    return count < TWD_FRAME_HEADER || payload_length(bytes) <= TWD_FRAME_MAX_PAYLOAD;
}

/* Drop what lies before the first possible start of a frame. */
static void skip_to_start(struct twd_frame_reader *reader)
{
    size_t start = 0;
    while (start < reader->count && !may_start_here(reader->buffer + start, reader->count - start))
        start++;
    if (start > 0) drop(reader, start);
}

static bool has_own_crc(const uint8_t *bytes, size_t before_crc)
{
    uint32_t crc = 0;
    for (unsigned i = 0; i < TWD_FRAME_CRC; i++)
        crc |= (uint32_t)bytes[before_crc + i] << (8U * i);
    return crc == twd_crc32(bytes, before_crc);
}

enum twd_frame_found twd_frame_reader_next(struct twd_frame_reader *reader, struct twd_frame *frame)
{
    skip_to_start(reader);
    if (reader->count < TWD_FRAME_HEADER) return TWD_FRAME_NONE;
    const size_t length = payload_length(reader->buffer);
    const size_t before_crc = TWD_FRAME_HEADER + length;
    if (reader->count < before_crc + TWD_FRAME_CRC) return TWD_FRAME_NONE;
    if (!has_own_crc(reader->buffer, before_crc)) {
        drop(reader, 1);
        return TWD_FRAME_DAMAGED;
    }

    frame->type = reader->buffer[2];
    frame->sequence = reader->buffer[3];
    frame->length = (uint16_t)length;
    memcpy(frame->payload, reader->buffer + TWD_FRAME_HEADER, length);
    drop(reader, before_crc + TWD_FRAME_CRC);
    return TWD_FRAME_WHOLE;
}
