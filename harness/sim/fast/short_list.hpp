// short_list.hpp: a list of fixed room, for what a substep gathers.
#pragma once

#include <array>

namespace twiddle::sim
{

// The caller asks full() before it adds.
template <class Element, int room> class ShortList
{
  public:
    void clear()
    {
        size_ = 0;
    }
    bool full() const
    {
        return size_ == room;
    }
    void add(const Element &element)
    {
        element_[size_++] = element;
    }
    // One more, to be filled: it holds whatever stood there before.
    Element &add()
    {
        return element_[size_++];
    }
    Element &last()
    {
        return element_[size_ - 1];
    }
    int size() const
    {
        return size_;
    }
    Element &operator[](int i)
    {
        return element_[i];
    }
    const Element &operator[](int i) const
    {
        return element_[i];
    }
    Element *begin()
    {
        return element_.data();
    }
    Element *end()
    {
        return element_.data() + size_;
    }
    const Element *begin() const
    {
        return element_.data();
    }
    const Element *end() const
    {
        return element_.data() + size_;
    }

  private:
    std::array<Element, room> element_{};
    int size_ = 0;
};

} // namespace twiddle::sim
