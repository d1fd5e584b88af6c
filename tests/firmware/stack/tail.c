/* first tail-calls second: when second runs, first's frame is gone. */
__attribute__((noinline)) static int second(int value)
{
    volatile int kept[20];
    kept[value & 7] = value;
    return kept[3];
}

__attribute__((noinline)) int first(int value)
{
    volatile int kept[40];
    kept[value & 7] = value;
    return second(kept[3]);
}

int main(void)
{
    return first(2) + first(3);
}
