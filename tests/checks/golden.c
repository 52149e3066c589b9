/* golden FOLDER [JOURNAL]: plays every journal that FOLDER/hashes.txt names, or one of them, and compares the painting
 * at its end:
 *
 *     NAME TICKS HASH
 *
 * Depends on sim, the journal and libzstd alone, so that it is quickly built for another processor. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "journal_file.h"
#include "player.h"

static bool play(const char *path, int64_t *ticks, uint64_t *hash)
{
    const int threads = 2;
    struct player_maker maker = player_cpu(&threads);
    struct bytes bytes;
    struct player player;
    struct file_error error;
    if (!journal_file_read(path, JOURNAL_FILE_MOST, &bytes, &error)) {
        fprintf(stderr, "%s\n", error.text);
        return false;
    }
    bool good = player_open(&player, bytes.data, bytes.size, &maker, &error);
    while (good && player_tick(&player, &error)) {
    }
    good = good && error.text[0] == '\0' && player.reader.ending == JOURNAL_ENDS && player.reader.skipped == 0;
    if (good) {
        *ticks = player.ticked;
        *hash = painting_hash(engine_cpu_painting(player.engine));
    } else {
        fprintf(stderr, "%s: %s%s\n", path, error.text, player.reader.error.text);
    }
    player_close(&player);
    bytes_finish(&bytes);
    return good;
}

int main(int argc, char *argv[])
{
    char path[4096], name[256];
    int64_t wanted_ticks, ticks = 0;
    uint64_t wanted, hash = 0;
    int wrong = 0, count = 0;
    snprintf(path, sizeof path, "%s/hashes.txt", argc > 1 ? argv[1] : ".");
    FILE *list = fopen(path, "r");
    while (list && fscanf(list, "%255s %" SCNd64 " %" SCNx64, name, &wanted_ticks, &wanted) == 3) {
        if (argc > 2 && strcmp(name, argv[2]) != 0) {
            continue;
        }
        snprintf(path, sizeof path, "%s/%s", argv[1], name);
        bool good = play(path, &ticks, &hash) && ticks == wanted_ticks && hash == wanted;
        printf("%-6s %s %" PRId64 " %016" PRIx64 "\n", good ? "same" : "OTHER", name, ticks, hash);
        wrong += !good;
        count++;
    }
    if (list) {
        fclose(list);
    }
    return wrong == 0 && count > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
