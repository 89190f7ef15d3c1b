// SPDX-License-Identifier: BSD-3-Clause
// Preloaded into a run: kills it at its n-th call that changes files, has such a call fail, or has the n-th large allocation
// fail. Calls are counted from main on, of the files below FAULT_FOLDER.
//   FAULT_KIND   kill: at call FAULT_AT, before it; kill_within: a write does half of its bytes, then the kill; enospc, eio:
//                call FAULT_AT and all later ones that write fail; malloc: allocation FAULT_AT and all later ones of
//                FAULT_BYTES and more fail
//                count: none of this, allocations are counted as well
//   FAULT_COUNT  a file to which the number of calls is written at the end
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <unistd.h>

enum Kind { none, counting, kill_before, kill_within, no_space, broken_disk, no_memory };

static enum Kind kind = none;
static long fault_at = -1;
static size_t fault_bytes = 0;
static const char *folder = NULL;
static atomic_long n_calls = 0, n_large = 0;

static void die(void) { kill(getpid(), SIGKILL); }

__attribute__((constructor)) static void begin(void) {
  const char *name = getenv("FAULT_KIND"), *at = getenv("FAULT_AT"), *bytes = getenv("FAULT_BYTES");
  folder = getenv("FAULT_FOLDER");
  if (at) fault_at = atol(at);
  if (bytes) fault_bytes = (size_t)atol(bytes);
  if (!name) return;
  if (!strcmp(name, "count")) kind = counting;
  if (!strcmp(name, "kill")) kind = kill_before;
  if (!strcmp(name, "kill_within")) kind = kill_within;
  if (!strcmp(name, "enospc")) kind = no_space;
  if (!strcmp(name, "eio")) kind = broken_disk;
  if (!strcmp(name, "malloc")) kind = no_memory;
}

__attribute__((destructor)) static void end(void) {
  const char *path = getenv("FAULT_COUNT");
  if (!path) return;
  kind = none;
  FILE *file = fopen(path, "w");
  if (!file) return;
  fprintf(file, "%ld %ld\n", atomic_load(&n_calls), atomic_load(&n_large));
  fclose(file);
}

static int is_ours(const char *path) {
  if (!folder || !path) return 0;
  return path[0] != '/' || !strncmp(path, folder, strlen(folder));
}

static int is_our_file(int fd) {
  char link[64], path[4096];
  snprintf(link, sizeof link, "/proc/self/fd/%d", fd);
  const ssize_t n = readlink(link, path, sizeof path - 1);
  if (n <= 0 || !folder) return 0;
  path[n] = 0;
  return path[0] == '/' && !strncmp(path, folder, strlen(folder)) && !strstr(path, "printed.txt");
}

// Whether this call is to fail; kills where it is to kill.
static int fails(int is_write) {
  const long n = atomic_fetch_add(&n_calls, 1);
  if (kind == kill_before && n == fault_at) die();
  if (kind == kill_within && n == fault_at && !is_write) die();
  if ((kind != no_space && kind != broken_disk) || n < fault_at || fault_at < 0 || !is_write) return 0;
  errno = kind == no_space ? ENOSPC : EIO;
  return 1;
}

static int is_cut(void) { return kind == kill_within && atomic_load(&n_calls) == fault_at + 1; }

#define REAL(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

ssize_t write(int fd, const void *data, size_t n) {
  if (is_our_file(fd)) {
    if (fails(1)) return -1;
    if (is_cut()) {
      REAL(write)(fd, data, n / 2);
      die();
    }
  }
  return REAL(write)(fd, data, n);
}

ssize_t writev(int fd, const struct iovec *parts, int n) {
  if (is_our_file(fd) && fails(1)) return -1;
  return REAL(writev)(fd, parts, n);
}

ssize_t pwrite64(int fd, const void *data, size_t n, off64_t at) {
  if (is_our_file(fd)) {
    if (fails(1)) return -1;
    if (is_cut()) {
      REAL(pwrite64)(fd, data, n / 2, at);
      die();
    }
  }
  return REAL(pwrite64)(fd, data, n, at);
}

ssize_t pwrite(int fd, const void *data, size_t n, off_t at) { return pwrite64(fd, data, n, at); }

int fsync(int fd) { return is_our_file(fd) && fails(1) ? -1 : REAL(fsync)(fd); }

int fdatasync(int fd) { return is_our_file(fd) && fails(1) ? -1 : REAL(fdatasync)(fd); }

int ftruncate64(int fd, off64_t n) { return is_our_file(fd) && fails(1) ? -1 : REAL(ftruncate64)(fd, n); }

int ftruncate(int fd, off_t n) { return ftruncate64(fd, n); }

int close(int fd) {
  if (is_our_file(fd)) fails(0);
  return REAL(close)(fd);
}

int rename(const char *from, const char *to) { return is_ours(from) && fails(1) ? -1 : REAL(rename)(from, to); }

int unlink(const char *path) {
  if (is_ours(path)) fails(0);
  return REAL(unlink)(path);
}

int remove(const char *path) {
  if (is_ours(path)) fails(0);
  return REAL(remove)(path);
}

static int fails_to_open(const char *path, int flags) {
  return (flags & (O_WRONLY | O_RDWR | O_CREAT)) && is_ours(path) && fails(1);
}

int open64(const char *path, int flags, ...) {
  va_list more;
  va_start(more, flags);
  const mode_t mode = flags & O_CREAT ? va_arg(more, mode_t) : 0;
  va_end(more);
  return fails_to_open(path, flags) ? -1 : REAL(open64)(path, flags, mode);
}

int open(const char *path, int flags, ...) {
  va_list more;
  va_start(more, flags);
  const mode_t mode = flags & O_CREAT ? va_arg(more, mode_t) : 0;
  va_end(more);
  return fails_to_open(path, flags) ? -1 : REAL(open64)(path, flags, mode);
}

static FILE *open_stream(const char *path, const char *mode) {
  if (mode[0] != 'r' && is_ours(path) && fails(1)) return NULL;
  return REAL(fopen64)(path, mode);
}

FILE *fopen64(const char *path, const char *mode) { return open_stream(path, mode); }

FILE *fopen(const char *path, const char *mode) { return open_stream(path, mode); }

extern void *__libc_malloc(size_t n);

// H5AC_create of HDF5 1.10 does not look at what it gets: what its library takes for itself is let through.
static int is_of_hdf5(const void *caller) {
  Dl_info info;
  return dladdr(caller, &info) && info.dli_fname && strstr(info.dli_fname, "libhdf5");
}

void *malloc(size_t n) {
  if ((kind == no_memory || kind == counting) && n >= fault_bytes && !is_of_hdf5(__builtin_return_address(0))) {
    const long so_far = atomic_fetch_add(&n_large, 1);
    if (kind == no_memory && so_far >= fault_at) {
      errno = ENOMEM;
      return NULL;
    }
  }
  return __libc_malloc(n);
}
