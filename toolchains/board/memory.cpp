// The two functions of a C library that a compiler may call on its own.

#include <stddef.h>

extern "C" {

[[gnu::used]] void* memcpy(void* target, const void* source, size_t size) {
  for (size_t i = 0; i < size; ++i) static_cast<char*>(target)[i] = static_cast<const char*>(source)[i];
  return target;
}

[[gnu::used]] void* memset(void* target, int value, size_t size) {
  for (size_t i = 0; i < size; ++i) static_cast<char*>(target)[i] = static_cast<char>(value);
  return target;
}
}
