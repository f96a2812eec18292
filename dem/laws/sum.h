// Two contact laws acting side by side: forces add, each keeps its own memory.
#pragma once

#include "dem/contact.h"

namespace dem {

template <class A, class B>
struct Sum {
  A a;
  B b;

  static constexpr bool breaks = A::breaks || B::breaks;

  template <class T>
  struct Memory {
    typename A::template Memory<T> a;
    typename B::template Memory<T> b;
  };

  template <class T>
  static auto holds(const Memory<T>& memory) {
    return A::template holds<T>(memory.a) | B::template holds<T>(memory.b);
  }

  void set_time_step(double dt) {
    a.set_time_step(dt);
    b.set_time_step(dt);
  }

  template <class T>
  Response<T> operator()(const Contact<T>& contact, Memory<T>& memory) const {
    const Response<T> x = a(contact, memory.a), y = b(contact, memory.b);
    return {x.push + y.push, x.stone + y.stone, x.shear + y.shear, x.stiffness + y.stiffness};
  }
};

}  // namespace dem
