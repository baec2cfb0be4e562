/* A library for LD_PRELOAD: the N-th call that changes a file system below a folder fails, or the process is killed
 * before it.
 *   TANK_DATUM_CALLS_BELOW  the folder; only calls on paths below it, or on descriptors of such files, are counted
 *   TANK_DATUM_FAIL_AT      N, from 1; the call returns an error
 *   TANK_DATUM_FAIL_WITH    its errno, a number
 *   TANK_DATUM_KILL_AT      N; SIGKILL comes before the call
 *   TANK_DATUM_STOP_AT      N; a signal is sent to the process before the call, which then goes on
 *   TANK_DATUM_STOP_WITH    its number; SIGTERM when it is not set
 *   TANK_DATUM_COUNT_FILE   where the number of calls is written at the end of the process, outside of the folder */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

static int calls = 0;

static int number(const char* name) {
  const char* text = getenv(name);
  return text ? atoi(text) : 0;
}

static int below(const char* path) {
  const char* folder = getenv("TANK_DATUM_CALLS_BELOW");
  return folder && path && strncmp(path, folder, strlen(folder)) == 0;
}

static int below_descriptor(int descriptor) {
  char link[64], path[PATH_MAX];
  snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
  const ssize_t length = readlink(link, path, sizeof path - 1);
  if (length < 0) return 0;
  path[length] = '\0';
  return below(path);
}

/* Whether this call has to fail. */
static int fails(void) {
  const int now = __atomic_add_fetch(&calls, 1, __ATOMIC_SEQ_CST);
  if (now == number("TANK_DATUM_KILL_AT")) kill(getpid(), SIGKILL);
  if (now == number("TANK_DATUM_STOP_AT")) kill(getpid(), number("TANK_DATUM_STOP_WITH") ? number("TANK_DATUM_STOP_WITH") : SIGTERM);
  if (now != number("TANK_DATUM_FAIL_AT")) return 0;
  errno = number("TANK_DATUM_FAIL_WITH");
  return 1;
}

__attribute__((destructor)) static void write_count(void) {
  const char* path = getenv("TANK_DATUM_COUNT_FILE");
  FILE* file = path ? fopen(path, "w") : NULL;
  if (!file) return;
  fprintf(file, "%d\n", calls);
  fclose(file);
}

#define REAL(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

int mkdir(const char* path, mode_t mode) { return below(path) && fails() ? -1 : REAL(mkdir)(path, mode); }
int rmdir(const char* path) { return below(path) && fails() ? -1 : REAL(rmdir)(path); }
int unlink(const char* path) { return below(path) && fails() ? -1 : REAL(unlink)(path); }
int remove(const char* path) { return below(path) && fails() ? -1 : REAL(remove)(path); }
int rename(const char* from, const char* to) { return below(to) && fails() ? -1 : REAL(rename)(from, to); }

int unlinkat(int folder, const char* path, int flags) {
  const int counted = path[0] == '/' ? below(path) : below_descriptor(folder);
  return counted && fails() ? -1 : REAL(unlinkat)(folder, path, flags);
}

int renameat2(int from_folder, const char* from, int to_folder, const char* to, unsigned flags) {
  return below(to) && fails() ? -1 : REAL(renameat2)(from_folder, from, to_folder, to, flags);
}

int renameat(int from_folder, const char* from, int to_folder, const char* to) {
  return below(to) && fails() ? -1 : REAL(renameat)(from_folder, from, to_folder, to);
}

int link(const char* from, const char* to) { return below(to) && fails() ? -1 : REAL(link)(from, to); }

int open(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = flags & (O_CREAT | O_TMPFILE) ? va_arg(rest, mode_t) : 0;
  va_end(rest);
  return below(path) && fails() ? -1 : REAL(open)(path, flags, mode);
}

int open64(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = flags & (O_CREAT | O_TMPFILE) ? va_arg(rest, mode_t) : 0;
  va_end(rest);
  return below(path) && fails() ? -1 : REAL(open64)(path, flags, mode);
}

FILE* fopen(const char* path, const char* mode) { return below(path) && fails() ? NULL : REAL(fopen)(path, mode); }
FILE* fopen64(const char* path, const char* mode) { return below(path) && fails() ? NULL : REAL(fopen64)(path, mode); }

ssize_t write(int descriptor, const void* bytes, size_t count) {
  return below_descriptor(descriptor) && fails() ? -1 : REAL(write)(descriptor, bytes, count);
}

ssize_t writev(int descriptor, const struct iovec* parts, int count) {
  return below_descriptor(descriptor) && fails() ? -1 : REAL(writev)(descriptor, parts, count);
}

/* Nothing is waited for: a process that is killed loses nothing that the kernel has. */
int fsync(int descriptor) {
  if (!below_descriptor(descriptor)) return REAL(fsync)(descriptor);
  return fails() ? -1 : 0;
}
