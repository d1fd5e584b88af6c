/* The nRF51822's UART on the pins that a micro:bit's interface chip shows as a serial port over USB;
 * registers as the nRF51 Series Reference Manual names them. */
#include "uart.h"

#define REGISTER(address) (*(volatile uint32_t *)(address))

#define HFCLK_START REGISTER(0x40000000U)
#define HFCLK_STARTED REGISTER(0x40000100U)
#define GPIO_OUT_SET REGISTER(0x50000508U)
#define GPIO_DIRECTION_SET REGISTER(0x50000518U)
#define UART_START_RECEIVER REGISTER(0x40002000U)
#define UART_START_TRANSMITTER REGISTER(0x40002008U)
#define UART_RECEIVED REGISTER(0x40002108U)
#define UART_SENT REGISTER(0x4000211CU)
#define UART_ENABLE REGISTER(0x40002500U)
#define UART_PIN_OUT REGISTER(0x4000250CU)
#define UART_PIN_IN REGISTER(0x40002514U)
#define UART_BYTE_IN REGISTER(0x40002518U)
#define UART_BYTE_OUT REGISTER(0x4000251CU)
#define UART_SPEED REGISTER(0x40002524U)

enum { PIN_OUT = 24, PIN_IN = 25, ENABLED = 4, SPEED_115200 = 0x01D7E000 };

void uart_open(void)
{
    HFCLK_START = 1; /* the crystal: the other clock is too far from the line's */
    while (HFCLK_STARTED == 0) {
    }
    GPIO_OUT_SET = UINT32_C(1) << PIN_OUT; /* the line's rest */
    GPIO_DIRECTION_SET = UINT32_C(1) << PIN_OUT;
    UART_PIN_OUT = PIN_OUT;
    UART_PIN_IN = PIN_IN;
    UART_SPEED = SPEED_115200;
    UART_ENABLE = ENABLED;
    UART_RECEIVED = 0;
    UART_START_RECEIVER = 1;
    UART_START_TRANSMITTER = 1;
}

/* A byte that has come. Its event is cleared before it is read, since reading brings the next one's. */
static uint8_t take(void)
{
    UART_RECEIVED = 0;
    return (uint8_t)UART_BYTE_IN;
}

size_t uart_read(uint8_t *bytes, size_t capacity)
{
    size_t count = 0;
    while (UART_RECEIVED == 0) {
    }
    while (count < capacity && UART_RECEIVED != 0)
        bytes[count++] = take();
    return count;
}

void uart_write(const uint8_t *bytes, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        UART_SENT = 0;
        UART_BYTE_OUT = bytes[i];
        while (UART_SENT == 0) {
        }
    }
}
