// Large arrays in large pages, where there are such: a picture's depths, or a texture's texels, lie
// on thousands of usual ones, more than a processor keeps the places of.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace rasterlab {

inline constexpr std::align_val_t huge_page_size{std::size_t{1} << 21U};

/// Asks for large pages where memory that nobody has touched yet has room for them.
inline void advise_huge_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#if defined(__linux__)
  if (bytes < static_cast<std::size_t>(huge_page_size)) return;
  constexpr std::size_t page = 4096;  // or more: then the advice isn't taken
  const std::size_t before = (page - reinterpret_cast<std::uintptr_t>(memory) % page) % page;
  madvise(static_cast<std::byte*>(memory) + before, bytes - before, MADV_HUGEPAGE);
#endif
}

/// Memory that begins with a large page, if there are such. To be given back with
/// ::operator delete[](…, huge_page_size).
inline void* allocate_huge_pages(std::size_t bytes) {
  void* memory = ::operator new[](bytes, huge_page_size);
  advise_huge_pages(memory, bytes);
  return memory;
}

/// An array that is not initialized.
template <class T>
class HugePages {
 public:
  HugePages() = default;
  explicit HugePages(std::size_t count)
      : values_(static_cast<T*>(allocate_huge_pages(count * sizeof(T)))) {}

  T* get() const { return values_.get(); }

 private:
  struct Free {
    void operator()(T* values) const { ::operator delete[](values, huge_page_size); }
  };
  std::unique_ptr<T[], Free> values_;
};

/// For a container's elements; those that don't fill a large page stay on usual ones.
template <class T>
struct HugePageAllocator {
  using value_type = T;

  HugePageAllocator() = default;
  template <class Other>
  HugePageAllocator(const HugePageAllocator<Other>&) {}

  T* allocate(std::size_t count) {
    if (!fills_a_page(count)) return std::allocator<T>().allocate(count);
    return static_cast<T*>(allocate_huge_pages(count * sizeof(T)));
  }
  void deallocate(T* values, std::size_t count) {
    if (!fills_a_page(count)) return std::allocator<T>().deallocate(values, count);
    ::operator delete[](values, huge_page_size);
  }
  friend bool operator==(const HugePageAllocator&, const HugePageAllocator&) { return true; }

 private:
  static bool fills_a_page(std::size_t count) {
    return count >= static_cast<std::size_t>(huge_page_size) / sizeof(T);
  }
};

}  // namespace rasterlab
