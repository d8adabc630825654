// A sphere, made by name and measured at three points whose distances are known.
#include <vug/field/registry.h>

#include <iostream>

int main() {
  const vug::field::Field sphere = vug::field::make("sphere", {{"radius", 2.0}});
  const double centre = sphere.value({0, 0, 0});
  const double surface = sphere.value({0, 2, 0});
  const double outside = sphere.gradient({3, 0, 4}).value;
  std::cout << centre << ' ' << surface << ' ' << outside << '\n';
  return centre == -2 && surface == 0 && outside == 3 ? 0 : 1;
}
