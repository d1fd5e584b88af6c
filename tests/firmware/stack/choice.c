/* A switch by a table of jumps, in a function with a frame. */
__attribute__((noinline)) static int callee(int value)
{
    volatile int kept[10];
    kept[value & 7] = value;
    return kept[3];
}

__attribute__((noinline)) int choose(int value)
{
    volatile int kept[3];
    kept[value & 1] = value;
    switch (value) {
    case 0:
        kept[0] = callee(7);
        break;
    case 1:
        kept[1] = 77 + kept[0];
        break;
    case 2:
        kept[2] = callee(3) * kept[0];
        break;
    case 3:
        kept[0] = 9 - kept[1];
        break;
    case 4:
        kept[1] = 12 ^ kept[2];
        break;
    case 5:
        kept[2] = 99 + callee(5);
        break;
    case 6:
        kept[0] = 4 | kept[2];
        break;
    default:
        break;
    }
    return kept[0] + kept[1] + kept[2];
}

int main(void)
{
    volatile int argument = 3;
    return choose(argument);
}
