/* What newlib's vsnprintf links to: memory for the digits of a float, and files, which it never opens. */
#include "board.h"

#include <errno.h>
#include <stddef.h>

struct stat;

extern char board_heap_start[], board_heap_end[]; /* by boards/sections.ld */

void *_sbrk(ptrdiff_t size)
{
    static char *heap = board_heap_start;
    if (size > board_heap_end - heap) {
        errno = ENOMEM;
        return (void *)-1; /* NOLINT(performance-no-int-to-ptr): newlib's word for failure */
    }
    char *const block = heap;
    heap += size;
    return block;
}

static int no_files(void)
{
    errno = ENOSYS;
    return -1;
}

int _close(int file)
{
    (void)file;
    return no_files();
}

int _fstat(int file, struct stat *status)
{
    (void)file;
    (void)status;
    return no_files();
}

int _isatty(int file)
{
    (void)file;
    return no_files();
}

int _lseek(int file, int offset, int from)
{
    (void)file;
    (void)offset;
    (void)from;
    return no_files();
}

int _read(int file, char *data, int size)
{
    (void)file;
    (void)data;
    (void)size;
    return no_files();
}

int _write(int file, const char *data, int size)
{
    (void)file;
    (void)data;
    (void)size;
    return no_files();
}

int _getpid(void)
{
    return 1;
}

int _kill(int process, int signal)
{
    (void)process;
    (void)signal;
    return no_files();
}

void _exit(int status)
{
    board_exit(status);
}
