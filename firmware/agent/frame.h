/* frame.h: one message on a byte link, as the chip and the computer that drives it both write and read it
 * (docs/PROTOCOL.md).
 *
 *     byte 0, 1    0x54 0x57, "TW"
 *     byte 2       type (messages.h)
 *     byte 3       sequence number; an answer carries its request's
 *     byte 4, 5    length of the payload in bytes, low byte first, at most TWD_FRAME_MAX_PAYLOAD
 *     then         the payload
 *     last 4       CRC-32 (IEEE 802.3) of all bytes before it, low byte first
 *
 * No function here blocks, allocates or fails; what is no frame is skipped. */
#ifndef TWIDDLE_AGENT_FRAME_H
#define TWIDDLE_AGENT_FRAME_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define TWD_FRAME_HEADER 6U
#define TWD_FRAME_CRC 4U

/* Bytes of payload in one frame, at most: the largest message, a finger of four joints (messages.h), fits. */
#define TWD_FRAME_MAX_PAYLOAD 264U

/* Bytes of the longest frame. */
#define TWD_FRAME_MAX_SIZE (TWD_FRAME_HEADER + TWD_FRAME_MAX_PAYLOAD + TWD_FRAME_CRC)

/* One message. */
struct twd_frame {
    uint8_t type;
    uint8_t sequence;
    /* Of the payload, bytes; at most TWD_FRAME_MAX_PAYLOAD. */
    uint16_t length;
    uint8_t payload[TWD_FRAME_MAX_PAYLOAD];
};

/* CRC-32 as in IEEE 802.3 and zlib: reflected, polynomial 0x04C11DB7, start and final inversion 0xFFFFFFFF. */
uint32_t twd_crc32(const uint8_t *bytes, size_t count);

/* Write `frame` as bytes, [TWD_FRAME_MAX_SIZE]; returns how many there are. */
size_t twd_frame_encode(const struct twd_frame *frame, uint8_t *bytes);

/* Bytes that have arrived and are not yet frames. Zero it to start. */
struct twd_frame_reader {
    /* Bytes in `buffer`. */
    size_t count;
    uint8_t buffer[TWD_FRAME_MAX_SIZE];
};

/* What the bytes that have arrived are. */
enum twd_frame_found {
    TWD_FRAME_NONE = 0,   /* no whole frame yet; there is room for more bytes */
    TWD_FRAME_WHOLE = 1,  /* a frame */
    TWD_FRAME_DAMAGED = 2 /* the length of a frame, with a CRC that is not its own; ask again, as for a frame */
};

/* Where the next bytes of the link go, and how many at most; never 0 after twd_frame_reader_next found none. */
uint8_t *twd_frame_reader_space(struct twd_frame_reader *reader, size_t *capacity);

/* So many bytes were put there. */
void twd_frame_reader_filled(struct twd_frame_reader *reader, size_t count);

/* Take the first whole frame into `frame`. Bytes before it that are no frame are skipped; after a damaged frame, the
 * search goes on one byte behind its start, so that damage costs no frame but its own. */
enum twd_frame_found twd_frame_reader_next(struct twd_frame_reader *reader, struct twd_frame *frame);

#ifdef __cplusplus
}
#endif
#endif
