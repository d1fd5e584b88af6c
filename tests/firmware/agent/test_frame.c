/* Frames: their bytes, and what a reader makes of damaged, cut, oversized and random ones. */
#include "agent_test.h"

#include "agent/frame.h"

static struct twd_frame random_frame(uint64_t *random)
{
    struct twd_frame frame = {(uint8_t)random_below(random, 256), (uint8_t)random_below(random, 256), 0, {0}};
    frame.length = (uint16_t)random_below(random, TWD_FRAME_MAX_PAYLOAD + 1);
    for (unsigned i = 0; i < frame.length; i++)
        frame.payload[i] = (uint8_t)random_below(random, 256);
    return frame;
}

static bool equal(const struct twd_frame *a, const struct twd_frame *b)
{
    return a->type == b->type && a->sequence == b->sequence && a->length == b->length &&
           memcmp(a->payload, b->payload, a->length) == 0;
}

/* What a reader found in a row of bytes. */
struct findings {
    unsigned frames;
    unsigned damaged;
    struct twd_frame last;
};

/* Give `bytes` to the reader in pieces of at most `piece` bytes, and collect what it finds. */
static void feed(struct twd_frame_reader *reader, const uint8_t *bytes, size_t count, size_t piece,
                 struct findings *found)
{
    while (count > 0) {
        size_t some = 0;
        uint8_t *const space = twd_frame_reader_space(reader, &some);
        assert_true(some > 0);
        if (some > piece) some = piece;
        if (some > count) some = count;
        memcpy(space, bytes, some);
        twd_frame_reader_filled(reader, some);
        bytes += some;
        count -= some;
        struct twd_frame frame;
        enum twd_frame_found what;
        while ((what = twd_frame_reader_next(reader, &frame)) != TWD_FRAME_NONE) {
            if (what == TWD_FRAME_WHOLE) {
                found->frames++;
                found->last = frame;
            } else {
                found->damaged++;
            }
        }
    }
}

static struct findings findings_in(const uint8_t *bytes, size_t count, size_t piece)
{
    struct twd_frame_reader reader = {0, {0}};
    struct findings found = {0, 0, {0, 0, 0, {0}}};
    feed(&reader, bytes, count, piece, &found);
    return found;
}

/* The CRC is IEEE 802.3's. Expected: the check value that catalogues of CRCs list for "123456789". */
static void crc_has_the_published_check_value(void **state)
{
    (void)state;
    assert_int_equal(twd_crc32((const uint8_t *)"123456789", 9), 0xCBF43926U);
}

/* The bytes of the frames that docs/PROTOCOL.md prints. Expected: the payloads by hand, the CRCs from Python's
 * zlib.crc32. */
static void frames_have_the_documented_bytes(void **state)
{
    static const struct {
        struct twd_frame frame;
        uint8_t bytes[46];
    } documented[] = {
        {{0x01, 1, 0, {0}}, {0x54, 0x57, 0x01, 0x01, 0x00, 0x00, 0xCB, 0xF5, 0x90, 0x15}},
        {{0x81, 1, 24, {1, 0, 0, 0, 2, 0, 0, 0, 8, 0, 0, 0, 5, 0, 0, 0, 22, 0, 0, 0, 27, 0, 0, 0}},
         {0x54, 0x57, 0x81, 0x01, 0x18, 0x00, 0x01, 0x00, 0x00, 0x00, 0x02, 0x00, 0x00, 0x00, 0x08, 0x00, 0x00,
          0x00, 0x05, 0x00, 0x00, 0x00, 0x16, 0x00, 0x00, 0x00, 0x1B, 0x00, 0x00, 0x00, 0x6F, 0xCF, 0x9E, 0x4C}},
        {{0x11, 8, 36, {1, 0,  0, 0, 0,  0, 0, 4, 0, 0, 0, 0, 0, 0, 0, 0xF8, 0,    0,
                        0, 16, 0, 0, 24, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,    0xFC, 0xFF}},
         {0x54, 0x57, 0x11, 0x08, 0x24, 0x00, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x04, 0x00, 0x00,
          0x00, 0x00, 0x00, 0x00, 0x00, 0xF8, 0x00, 0x00, 0x00, 0x10, 0x00, 0x00, 0x18, 0x00, 0x00, 0x00,
          0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xFC, 0xFF, 0x66, 0xA3, 0xBB, 0xCE}},
        {{0x12, 7, 4, {0, 0, 0x80, 0}},
         {0x54, 0x57, 0x12, 0x07, 0x04, 0x00, 0x00, 0x00, 0x80, 0x00, 0x7E, 0xB0, 0x6D, 0x1E}},
        {{0xFF, 7, 8, {4}},
         {0x54, 0x57, 0xFF, 0x07, 0x08, 0x00, 0x04, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x26, 0x5A, 0x13}},
    };
    (void)state;
    for (size_t i = 0; i < sizeof documented / sizeof documented[0]; i++) {
        uint8_t bytes[TWD_FRAME_MAX_SIZE];
        const size_t count = twd_frame_encode(&documented[i].frame, bytes);
        assert_int_equal(count, documented[i].frame.length + 10U);
        assert_memory_equal(bytes, documented[i].bytes, count);
    }
}

/* Any frame comes back as it was, in pieces of any size, one behind the other. */
static void frames_come_back_in_pieces_of_any_size(void **state)
{
    uint64_t random = 1;
    struct twd_frame_reader reader = {0, {0}};
    (void)state;
    for (unsigned i = 0; i < 2000; i++) {
        const struct twd_frame sent = random_frame(&random);
        uint8_t bytes[TWD_FRAME_MAX_SIZE];
        const size_t count = twd_frame_encode(&sent, bytes);
        struct findings found = {0, 0, {0, 0, 0, {0}}};
        feed(&reader, bytes, count, 1 + random_below(&random, 40), &found);
        assert_int_equal(found.frames, 1);
        assert_int_equal(found.damaged, 0);
        assert_true(equal(&found.last, &sent));
    }
}

/* A frame with one byte changed, at any position and in any way, is never taken for a frame; the next one is read. */
static void every_changed_byte_is_noticed(void **state)
{
    const struct twd_frame sent = {0x11, 9, 12, {1, 2, 3, 0x54, 0x57, 6, 7, 8, 9, 10, 11, 12}};
    const struct twd_frame next = {0x12, 10, 4, {1, 2, 3, 4}};
    uint8_t bytes[2 * TWD_FRAME_MAX_SIZE + TWD_FRAME_MAX_SIZE] = {0};
    const size_t first = twd_frame_encode(&sent, bytes);
    const size_t both = first + twd_frame_encode(&next, bytes + first);
    (void)state;
    for (size_t at = 0; at < first; at++) {
        for (unsigned change = 1; change < 256; change++) {
            bytes[at] = (uint8_t)(bytes[at] ^ change);
            /* The zeros behind the frames end a length that was made longer. */
            const struct findings found = findings_in(bytes, both + TWD_FRAME_MAX_SIZE, 7);
            bytes[at] = (uint8_t)(bytes[at] ^ change);
            assert_int_equal(found.frames, 1);
            assert_true(equal(&found.last, &next));
        }
    }
}

/* A frame that was cut off after any byte costs nothing but itself: the whole frame behind it is read. */
static void cut_frame_costs_only_itself(void **state)
{
    uint64_t random = 2;
    struct twd_frame sent = random_frame(&random);
    const struct twd_frame next = {0x01, 3, 0, {0}};
    (void)state;
    sent.length = 100;
    uint8_t whole[TWD_FRAME_MAX_SIZE];
    const size_t count = twd_frame_encode(&sent, whole);
    for (size_t kept = 1; kept < count; kept++) {
        uint8_t bytes[3 * TWD_FRAME_MAX_SIZE] = {0};
        memcpy(bytes, whole, kept);
        const size_t end = kept + twd_frame_encode(&next, bytes + kept);
        const struct findings found = findings_in(bytes, end + TWD_FRAME_MAX_SIZE, 64);
        assert_int_equal(found.frames, 1);
        assert_true(equal(&found.last, &next));
    }
}

/* A length beyond the largest is no frame, and is not waited for. */
static void oversized_length_is_not_waited_for(void **state)
{
    const struct twd_frame next = {0x10, 4, 8, {8, 7, 6, 5, 4, 3, 2, 1}};
    (void)state;
    for (unsigned length = TWD_FRAME_MAX_PAYLOAD + 1; length <= 0xFFFF; length += 251) {
        uint8_t bytes[6 + TWD_FRAME_MAX_SIZE] = {0x54, 0x57, 0x10, 0x01, (uint8_t)length, (uint8_t)(length >> 8)};
        const size_t count = 6 + twd_frame_encode(&next, bytes + 6);
        const struct findings found = findings_in(bytes, count, count);
        assert_int_equal(found.frames, 1);
        assert_true(equal(&found.last, &next));
    }
}

/* Noise before a frame, many half starts among it, is skipped. */
static void noise_before_a_frame_is_skipped(void **state)
{
    static const uint8_t likely[] = {0x54, 0x57, 0x54, 0x00, 0xFF, 0x12};
    uint64_t random = 3;
    (void)state;
    for (unsigned i = 0; i < 2000; i++) {
        const struct twd_frame sent = random_frame(&random);
        uint8_t bytes[60 + 2 * TWD_FRAME_MAX_SIZE] = {0};
        const size_t noise = random_below(&random, 60);
        for (size_t at = 0; at < noise; at++)
            bytes[at] = likely[random_below(&random, sizeof likely)];
        const size_t end = noise + twd_frame_encode(&sent, bytes + noise);
        const struct findings found = findings_in(bytes, end + TWD_FRAME_MAX_SIZE, 1 + random_below(&random, 300));
        assert_int_equal(found.frames, 1);
        assert_true(equal(&found.last, &sent));
    }
}

/* Random bytes and mutilated frames by the million never make a frame, nor a reader without room. */
static void random_bytes_make_no_frame(void **state)
{
    uint64_t random = 4;
    struct twd_frame_reader reader = {0, {0}};
    struct findings found = {0, 0, {0, 0, 0, {0}}};
    (void)state;
    for (unsigned i = 0; i < 20000; i++) {
        const struct twd_frame sent = random_frame(&random);
        uint8_t bytes[TWD_FRAME_MAX_SIZE];
        const size_t count = twd_frame_encode(&sent, bytes);
        const unsigned changes = 1 + random_below(&random, 4);
        for (unsigned change = 0; change < changes; change++)
            bytes[random_below(&random, (uint32_t)count)] ^= (uint8_t)(1U << change);
        feed(&reader, bytes, count, 1 + random_below(&random, 300), &found);
    }
    assert_int_equal(found.frames, 0);
    assert_true(found.damaged > 10000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(crc_has_the_published_check_value),
        cmocka_unit_test(frames_have_the_documented_bytes),
        cmocka_unit_test(frames_come_back_in_pieces_of_any_size),
        cmocka_unit_test(every_changed_byte_is_noticed),
        cmocka_unit_test(cut_frame_costs_only_itself),
        cmocka_unit_test(oversized_length_is_not_waited_for),
        cmocka_unit_test(noise_before_a_frame_is_skipped),
        cmocka_unit_test(random_bytes_make_no_frame),
    };
    return cmocka_run_group_tests_name("frame", tests, NULL, NULL);
}
