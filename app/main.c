#include <stdio.h>

#include "command.h"

int main(int argc, char *argv[])
{
    int status = command_line(argc, argv);
    if (fflush(stdout) != 0 || ferror(stdout)) {
        fprintf(stderr, "frond: what was printed could not be written\n");
        return EXIT_STATUS_FAILED;
    }
    return status;
}
