/* Stacks without a bound. */
int (*volatile chosen)(int);

__attribute__((noinline)) int through_a_pointer(int value)
{
    return chosen(value) + 1;
}

__attribute__((noinline)) int through_a_pointer_at_last(int value)
{
    return chosen(value + 1);
}

int ping(int value);

__attribute__((noinline)) int pong(int value)
{
    return value > 1 ? ping(value - 1) + 2 * value : 0;
}

__attribute__((noinline)) int ping(int value)
{
    return value > 1 ? pong(value - 1) + 3 * value : 1;
}

__attribute__((noinline)) int variable(int value)
{
    volatile int kept[value];
    kept[0] = value;
    return kept[0];
}

__attribute__((noinline)) int caller(int value)
{
    return ping(value) + 1;
}

int main(void)
{
    return through_a_pointer(1) + through_a_pointer_at_last(1) + caller(2) + variable(3);
}
