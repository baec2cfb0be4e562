// A library for LD_PRELOAD: the N-th operator new of a process throws std::bad_alloc. Calls are counted from the first
// of sigaction() on, with which runMain begins: what libraries make before main() cannot be caught.
//   TANK_DATUM_FAIL_NEW_AT     N, from 1
//   TANK_DATUM_NEW_COUNT_FILE  where the number of calls is written at the end of the process
#include <dlfcn.h>
#include <signal.h>

#include <atomic>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <new>

namespace {

std::atomic<bool> counting{false};
std::atomic<long> calls{0};
long fail_at = 0;

__attribute__((destructor)) void writeCount() {
  const char* path = std::getenv("TANK_DATUM_NEW_COUNT_FILE");
  std::FILE* file = path ? std::fopen(path, "w") : nullptr;
  if (!file) return;
  std::fprintf(file, "%ld\n", calls.load());
  std::fclose(file);
}

void* made(std::size_t size, std::size_t alignment) {
  if (counting && ++calls == fail_at) return nullptr;
  if (alignment <= alignof(std::max_align_t)) return std::malloc(size > 0 ? size : 1);
  return std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
}

void* madeOrThrown(std::size_t size, std::size_t alignment) {
  if (void* memory = made(size, alignment)) return memory;
  throw std::bad_alloc();
}

}  // namespace

extern "C" int sigaction(int number, const struct sigaction* action, struct sigaction* old) noexcept {
  if (!counting.exchange(true)) {
    const char* text = std::getenv("TANK_DATUM_FAIL_NEW_AT");
    fail_at = text ? std::atol(text) : 0;
  }
  return reinterpret_cast<decltype(&::sigaction)>(::dlsym(RTLD_NEXT, "sigaction"))(number, action, old);
}

void* operator new(std::size_t size) { return madeOrThrown(size, 1); }
void* operator new[](std::size_t size) { return madeOrThrown(size, 1); }
void* operator new(std::size_t size, std::align_val_t a) { return madeOrThrown(size, static_cast<std::size_t>(a)); }
void* operator new[](std::size_t size, std::align_val_t a) { return madeOrThrown(size, static_cast<std::size_t>(a)); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return made(size, 1); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return made(size, 1); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
