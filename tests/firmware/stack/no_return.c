/* stop does not return, so that the end of ends_with_stop is no way into again, which stands behind it and calls it. */
__attribute__((noreturn)) void stop(int value)
{
    volatile int kept = value;
    for (;;)
        kept = kept + 1;
}

__attribute__((noreturn)) void ends_with_stop(int value)
{
    volatile int kept = value;
    stop(kept + 1);
}

void again(int value)
{
    volatile int kept = value;
    if (kept > 0) ends_with_stop(kept);
}

int main(void)
{
    again(1);
    return 0;
}
