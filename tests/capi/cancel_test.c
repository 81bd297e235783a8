/* SPDX-License-Identifier: MIT */
/* A thread that is cancelled while it waits for a file ends after the call, not in it. */
#define _POSIX_C_SOURCE 200809L
#include "check.h"

#include <fcntl.h>
#include <pthread.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

static const char *const path = "cancel_test.fifo";
static nurbs_status status = NURBS_OK;

static void *read_pipe(void *unused) {
    nurbs_list *list = NULL;
    status = nurbs_read_file(path, NULL, &list);
    pthread_testcancel();
    return unused;
}

int main(void) {
    pthread_t thread;
    void *result = NULL;
    remove(path);
    CHECK(mkfifo(path, 0600) == 0);
    CHECK(pthread_create(&thread, NULL, read_pipe, NULL) == 0);
    const int pipe = open(path, O_WRONLY); /* waits until the library has opened the other end */
    CHECK(pthread_cancel(thread) == 0);
    CHECK(write(pipe, "no file", 7) == 7 && close(pipe) == 0);
    CHECK(pthread_join(thread, &result) == 0);
    CHECK(result == PTHREAD_CANCELED && status == NURBS_ERROR_FORMAT);
    remove(path);
    return check_summary("cancel");
}
