#include "broker.h"

#include <errno.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <mosquitto.h>

enum { KEEP_ALIVE_S = 20, TURN_MS = 100, LINE = 300, QOS = 1, FIELDS = 5 };

struct broker {
    struct mosquitto *client;
    char *fields[FIELDS]; /* copies: host, ca, certificate, key, credentials */
    int port;
    char topics[BROKER_TOPICS][BROKER_TOPIC];
    char alive[BROKER_TOPIC];
    bool connected, refused; /* the thread's */
    pthread_t thread;
    pthread_mutex_t mutex; /* for all that follows */
    pthread_cond_t changed;
    bool ends, ended, abandoned; /* it shall; the thread has; the thread frees all this when it does */
    bool has_line;
    char line[LINE];
    struct broker_post {
        char topic[BROKER_TOPIC];
        char *text; /* owned; NULL: none waits here */
    } posts[BROKER_TOPICS];
    struct broker_message waiting[BROKER_WAITING];
    int waiting_count;
};

enum { HOST, CA, CERTIFICATE, KEY, CREDENTIALS };

static void say(struct broker *broker, const char *what, const char *why)
{
    pthread_mutex_lock(&broker->mutex);
    snprintf(broker->line, sizeof broker->line, "broker %.100s: %s%s%s", broker->fields[HOST], what, *why ? ": " : "",
             why);
    broker->has_line = true;
    pthread_mutex_unlock(&broker->mutex);
}

static void on_connect(struct mosquitto *client, void *context, int code)
{
    struct broker *broker = context;
    if (code != 0) {
        broker->refused = true;
        say(broker, "refuses", mosquitto_connack_string(code));
        return;
    }
    broker->connected = true;
    mosquitto_publish(client, NULL, broker->alive, 1, "1", QOS, true);
    for (int i = 0; i < BROKER_TOPICS && broker->topics[i][0]; i++) {
        mosquitto_subscribe(client, NULL, broker->topics[i], QOS);
    }
    say(broker, "connected", "");
}

static void on_message(struct mosquitto *client, void *context, const struct mosquitto_message *message)
{
    struct broker *broker = context;
    (void)client;
    if (message->payloadlen < 0 || message->payloadlen >= BROKER_TEXT || strlen(message->topic) >= BROKER_TOPIC) {
        return;
    }
    pthread_mutex_lock(&broker->mutex);
    if (broker->waiting_count < BROKER_WAITING) {
        struct broker_message *taken = &broker->waiting[broker->waiting_count++];
        snprintf(taken->topic, sizeof taken->topic, "%s", message->topic);
        snprintf(taken->text, sizeof taken->text, "%.*s", message->payloadlen,
                 message->payload ? (const char *)message->payload : "");
    }
    pthread_mutex_unlock(&broker->mutex);
}

/* The first two lines of the file. */
static bool log_in(struct broker *broker)
{
    char user[BROKER_TOPIC] = "", password[BROKER_TOPIC] = "";
    FILE *file = fopen(broker->fields[CREDENTIALS], "re");
    bool good = file && fgets(user, sizeof user, file) && fgets(password, sizeof password, file);
    if (file) {
        fclose(file);
    }
    user[strcspn(user, "\r\n")] = password[strcspn(password, "\r\n")] = '\0';
    good = good && mosquitto_username_pw_set(broker->client, user, password) == MOSQ_ERR_SUCCESS;
    explicit_bzero(password, sizeof password);
    return good;
}

/* Files are read at each attempt: certificates are renewed while Frond runs. */
static bool greet(struct broker *broker)
{
    char **fields = broker->fields;
    if (fields[CREDENTIALS] && !log_in(broker)) {
        say(broker, "the credentials cannot be read", fields[CREDENTIALS]);
        return false;
    }
    if (fields[CA] && mosquitto_tls_set(broker->client, fields[CA], NULL, fields[CERTIFICATE], fields[KEY], NULL) !=
                          MOSQ_ERR_SUCCESS) {
        say(broker, "its certificates cannot be used", fields[CA]);
        return false;
    }
    int code = mosquitto_connect(broker->client, fields[HOST], broker->port, KEEP_ALIVE_S);
    if (code != MOSQ_ERR_SUCCESS) {
        say(broker, "cannot be reached", code == MOSQ_ERR_ERRNO ? strerror(errno) : mosquitto_strerror(code));
    }
    return code == MOSQ_ERR_SUCCESS;
}

static void send_posts(struct broker *broker)
{
    pthread_mutex_lock(&broker->mutex);
    for (int i = 0; i < BROKER_TOPICS; i++) {
        struct broker_post *post = &broker->posts[i];
        if (post->text && mosquitto_publish(broker->client, NULL, post->topic, (int)strlen(post->text), post->text, QOS,
                                            true) == MOSQ_ERR_SUCCESS) {
            free(post->text);
            post->text = NULL;
        }
    }
    pthread_mutex_unlock(&broker->mutex);
}

static bool has_ended(struct broker *broker)
{
    pthread_mutex_lock(&broker->mutex);
    bool ends = broker->ends;
    pthread_mutex_unlock(&broker->mutex);
    return ends;
}

static void talk(struct broker *broker)
{
    int code = MOSQ_ERR_SUCCESS;
    broker->connected = broker->refused = false;
    while (code == MOSQ_ERR_SUCCESS && !has_ended(broker)) {
        code = mosquitto_loop(broker->client, TURN_MS, 1);
        if (broker->connected) {
            send_posts(broker);
        }
    }
    if (broker->refused) {
        return; /* it has said why */
    }
    if (code != MOSQ_ERR_SUCCESS) {
        say(broker, broker->connected ? "lost" : "does not let this in", mosquitto_strerror(code));
        return;
    }
    if (broker->connected) { /* goodbye: a will is for accidents */
        send_posts(broker);
        mosquitto_publish(broker->client, NULL, broker->alive, 1, "0", QOS, true);
        for (int i = 0; i < 10 && mosquitto_loop(broker->client, TURN_MS / 10, 1) == MOSQ_ERR_SUCCESS; i++) {
        }
    }
    mosquitto_disconnect(broker->client);
    mosquitto_loop(broker->client, TURN_MS, 1);
}

static struct timespec in_seconds(int seconds)
{
    struct timespec until;
    clock_gettime(CLOCK_MONOTONIC, &until);
    until.tv_sec += seconds;
    return until;
}

/* All but the library, whose count of users is not guarded against other threads. */
static void finish(struct broker *broker)
{
    mosquitto_destroy(broker->client);
    pthread_cond_destroy(&broker->changed);
    pthread_mutex_destroy(&broker->mutex);
    for (int i = 0; i < BROKER_TOPICS; i++) {
        free(broker->posts[i].text);
    }
    for (int i = 0; i < FIELDS; i++) {
        free(broker->fields[i]);
    }
    free(broker);
}

static void *work(void *context)
{
    struct broker *broker = context;
    int wait_s = 1;
    while (!has_ended(broker)) {
        if (greet(broker)) {
            talk(broker);
            wait_s = broker->connected ? 1 : wait_s;
        }
        struct timespec until = in_seconds(wait_s);
        wait_s = 2 * wait_s < BROKER_AGAIN_MOST_S ? 2 * wait_s : BROKER_AGAIN_MOST_S;
        pthread_mutex_lock(&broker->mutex);
        while (!broker->ends && pthread_cond_timedwait(&broker->changed, &broker->mutex, &until) != ETIMEDOUT) {
        }
        pthread_mutex_unlock(&broker->mutex);
    }
    pthread_mutex_lock(&broker->mutex);
    broker->ended = true;
    bool abandoned = broker->abandoned;
    pthread_cond_signal(&broker->changed);
    pthread_mutex_unlock(&broker->mutex);
    if (abandoned) {
        finish(broker);
    }
    return NULL;
}

static bool copy_def(struct broker *broker, const struct broker_def *def)
{
    const char *fields[FIELDS] = {def->host, def->ca, def->certificate, def->key, def->credentials};
    bool good = true;
    for (int i = 0; i < FIELDS; i++) {
        broker->fields[i] = fields[i] ? strdup(fields[i]) : NULL;
        good = good && (broker->fields[i] || !fields[i]);
    }
    for (int i = 0; i < BROKER_TOPICS && def->topics[i]; i++) {
        snprintf(broker->topics[i], BROKER_TOPIC, "%s", def->topics[i]);
    }
    snprintf(broker->alive, sizeof broker->alive, "%s", def->alive);
    broker->port = def->port;
    return good;
}

struct broker *broker_create(const struct broker_def *def, struct device_error *error)
{
    struct broker *broker = calloc(1, sizeof *broker);
    pthread_condattr_t attribute;
    if (!broker) {
        device_fail(error, "memory is short");
        return NULL;
    }
    pthread_condattr_init(&attribute);
    pthread_condattr_setclock(&attribute, CLOCK_MONOTONIC);
    pthread_cond_init(&broker->changed, &attribute);
    pthread_condattr_destroy(&attribute);
    pthread_mutex_init(&broker->mutex, NULL);
    mosquitto_lib_init();
    broker->client = mosquitto_new(NULL, true, broker);
    bool good = broker->client && copy_def(broker, def) &&
                mosquitto_will_set(broker->client, broker->alive, 1, "0", QOS, true) == MOSQ_ERR_SUCCESS;
    if (good) {
        mosquitto_connect_callback_set(broker->client, on_connect);
        mosquitto_message_callback_set(broker->client, on_message);
        good = pthread_create(&broker->thread, NULL, work, broker) == 0;
    }
    if (!good) {
        device_fail(error, "a topic is none, or memory is short");
        finish(broker);
        mosquitto_lib_cleanup();
        return NULL;
    }
    return broker;
}

void broker_destroy(struct broker *broker)
{
    if (!broker) {
        return;
    }
    pthread_t thread = broker->thread;
    struct timespec until = in_seconds(BROKER_GOODBYE_S);
    pthread_mutex_lock(&broker->mutex);
    broker->ends = true;
    pthread_cond_signal(&broker->changed);
    while (!broker->ended && pthread_cond_timedwait(&broker->changed, &broker->mutex, &until) != ETIMEDOUT) {
    }
    bool abandoned = broker->abandoned = !broker->ended;
    pthread_mutex_unlock(&broker->mutex);
    if (abandoned) { /* in a connect() that nothing answers, for two minutes, or in a search for the host's address */
        pthread_detach(thread);
        return;
    }
    pthread_join(thread, NULL);
    finish(broker);
    mosquitto_lib_cleanup();
}

bool broker_publish(struct broker *broker, const char *topic, const char *text)
{
    struct broker_post *place = NULL;
    char *copy = strdup(text);
    pthread_mutex_lock(&broker->mutex);
    for (int i = 0; i < BROKER_TOPICS; i++) { /* the place of this topic, else an empty one */
        struct broker_post *post = &broker->posts[i];
        if ((post->text && strcmp(post->topic, topic) == 0) || (!post->text && !place)) {
            place = post;
        }
    }
    bool good = copy && place;
    if (good) {
        free(place->text);
        place->text = copy;
        snprintf(place->topic, sizeof place->topic, "%s", topic);
    }
    pthread_mutex_unlock(&broker->mutex);
    if (!good) {
        free(copy);
    }
    return good;
}

bool broker_message(struct broker *broker, struct broker_message *message)
{
    pthread_mutex_lock(&broker->mutex);
    bool has = broker->waiting_count > 0;
    if (has) {
        *message = broker->waiting[0];
        broker->waiting_count--;
        memmove(broker->waiting, broker->waiting + 1, (size_t)broker->waiting_count * sizeof broker->waiting[0]);
    }
    pthread_mutex_unlock(&broker->mutex);
    return has;
}

bool broker_log(struct broker *broker, char *line, int size)
{
    pthread_mutex_lock(&broker->mutex);
    bool has = broker->has_line;
    if (has) {
        snprintf(line, (size_t)size, "%s", broker->line);
        broker->has_line = false;
    }
    pthread_mutex_unlock(&broker->mutex);
    return has;
}
