// SPDX-License-Identifier: MIT
// The contacts of the eclipse nearest to a date.
#include <coppermoon/eclipse/contacts.h>

#include <cstdio>

using namespace coppermoon;

void print(const char* name, const std::optional<almanac::Instant>& when) {
  if (when) std::printf("%-9s%s\n", name, almanac::utc_text(*when).c_str());
}

int main() {
  const auto date = almanac::instant_from_utc("2018-07-27");
  const auto nearest = eclipse::nearest_eclipse(date, eclipse::ShadowConvention::danjon);
  const auto& contacts = nearest.contacts;
  print("P1", contacts.P1);
  print("U1", contacts.U1);
  print("U2", contacts.U2);
  print("greatest", nearest.greatest);
  print("U3", contacts.U3);
  print("U4", contacts.U4);
  print("P4", contacts.P4);
}
