// Large arrays in large pages, where there are such: a picture's depths lie on thousands of usual
// ones, more than a processor keeps the places of.
#pragma once

#include <cstddef>
#include <memory>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace rasterlab {

/// An array that is not initialized.
template <class T>
class HugePages {
 public:
  HugePages() = default;
  explicit HugePages(std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    values_.reset(static_cast<T*>(::operator new[](bytes, alignment)));
#if defined(__linux__)
    if (bytes >= static_cast<std::size_t>(alignment)) {
      madvise(values_.get(), bytes, MADV_HUGEPAGE);  // no more than advice
    }
#endif
  }

  T* get() const {
    return values_.get();
  }

 private:
  static constexpr std::align_val_t alignment{std::size_t{1} << 21U};

  struct Free {
    void operator()(T* values) const { ::operator delete[](values, alignment); }
  };
  std::unique_ptr<T[], Free> values_;
};

}  // namespace rasterlab
