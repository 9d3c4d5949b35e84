#pragma once
// Turns a fuzzer's bytes into numbers of every size, and into special ones.

#include <stddef.h>
#include <stdint.h>

#include <cmath>
#include <cstring>
#include <impact/status.hpp>
#include <limits>

namespace impact::fuzz {

class Bytes {
 public:
  Bytes(const uint8_t* data, size_t size) : data_(data), size_(size) {}

  bool is_empty() const { return size_ == 0; }
  uint8_t byte() {
    if (size_ == 0) return 0;
    --size_;
    return *data_++;
  }
  // A value of any bits. Bits beyond the end are zero.
  template <class Plain> Plain bits() {
    Plain value{};
    const size_t count = size_ < sizeof value ? size_ : sizeof value;
    if (count > 0) std::memcpy(reinterpret_cast<char*>(&value), data_, count);
    data_ += count;
    size_ -= count;
    return value;
  }
  size_t below(size_t count) { return byte() % count; }

  // Mostly a number within the range, log-uniform. Sometimes one of its ends, a number outside it, or a NaN.
  double number(Range range) {
    const double least = range.least > 1e-12 ? range.least : 1e-12;
    const uint8_t kind = byte();
    if (kind >= 32) {
      const double share = bits<uint16_t>() / 65535.0, size = least * std::pow(range.most / least, share);
      return range.least < 0 && kind % 2 == 1 ? -size : size;
    }
    using Double = std::numeric_limits<double>;
    const double special[] = {range.least, range.most, 0, 1, Double::infinity(), Double::quiet_NaN()};
    if (kind % 8 < 6) return special[kind % 8];
    return kind % 8 == 6 ? bits<double>() : static_cast<double>(bits<float>());
  }

 private:
  const uint8_t* data_;
  size_t size_;
};

}  // namespace impact::fuzz
