// A library for LD_PRELOAD: the N-th operator new of a process throws std::bad_alloc. Calls are counted from main() on:
// what libraries make before cannot be caught.
//   TANK_DATUM_FAIL_NEW_AT     N, from 1
//   TANK_DATUM_FAIL_NEW_ON     set: all later ones throw too
//   TANK_DATUM_NEW_COUNT_FILE  where the number of calls is written at the end of the process
#include <dlfcn.h>

#include <atomic>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <new>

namespace {

std::atomic<bool> counting{false};
std::atomic<long> calls{0};
long fail_at = 0;
bool and_on = false;
int (*program)(int, char**, char**) = nullptr;

int countedProgram(int argc, char** argv, char** environment) {
  const char* text = std::getenv("TANK_DATUM_FAIL_NEW_AT");
  fail_at = text ? std::atol(text) : 0;
  and_on = std::getenv("TANK_DATUM_FAIL_NEW_ON") != nullptr;
  counting = true;
  return program(argc, argv, environment);
}

bool fails() {
  if (!counting) return false;
  const long call = ++calls;
  return call == fail_at || (and_on && fail_at > 0 && call > fail_at);
}

__attribute__((destructor)) void writeCount() {
  const char* path = std::getenv("TANK_DATUM_NEW_COUNT_FILE");
  std::FILE* file = path ? std::fopen(path, "w") : nullptr;
  if (!file) return;
  std::fprintf(file, "%ld\n", calls.load());
  std::fclose(file);
}

void* made(std::size_t size, std::size_t alignment) {
  if (fails()) return nullptr;
  if (alignment <= alignof(std::max_align_t)) return std::malloc(size > 0 ? size : 1);
  return std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
}

void* madeOrThrown(std::size_t size, std::size_t alignment) {
  if (void* memory = made(size, alignment)) return memory;
  throw std::bad_alloc();
}

}  // namespace

/// The C library's, which calls main().
extern "C" int __libc_start_main(int (*main)(int, char**, char**), int argc, char** argv, void (*init)(), void (*end)(),
                                 void (*end_of_loader)(), void* stack_end) {
  program = main;
  using Start = decltype(&__libc_start_main);
  const auto start = reinterpret_cast<Start>(::dlsym(RTLD_NEXT, "__libc_start_main"));
  return start(countedProgram, argc, argv, init, end, end_of_loader, stack_end);
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
