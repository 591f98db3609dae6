// SPDX-License-Identifier: MIT
#include <coppermoon/eclipse/contacts.h>

#include <cstdio>

using namespace coppermoon;

int main() {
  const auto eclipse = eclipse::nearest_eclipse(almanac::instant_from_utc("2018-07-27"),
                                                eclipse::ShadowConvention::danjon);
  const auto& [P1, U1, U2, U3, U4, P4] = eclipse.contacts;
  for (const auto& contact : {P1, U1, U2, U3, U4, P4})
    std::printf("%s\n", contact ? almanac::utc_text(*contact).c_str() : "none");
}
