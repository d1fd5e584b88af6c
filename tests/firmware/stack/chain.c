/* main -> shallow, main -> deep -> deeper, with frames of known sizes. */
__attribute__((noinline)) static int shallow(int value)
{
    volatile int kept[30];
    kept[value & 7] = value;
    return kept[3];
}

__attribute__((noinline)) static int deeper(int value)
{
    volatile int kept[20];
    kept[value & 7] = value;
    return kept[3];
}

__attribute__((noinline)) static int deep(int value)
{
    volatile int kept[20];
    kept[value & 7] = deeper(value + 1);
    return kept[3];
}

int main(void)
{
    volatile int argument = 3;
    const int first = shallow(argument);
    return first + deep(argument);
}
