// udunits, opened when the module is loaded, so that a wheel neither holds nor needs it. The functions have the
// library's names in a namespace, and are pointers; they are null where the library is not installed. Only units.cpp
// includes this.
#pragma once

#include <dlfcn.h>
#include <udunits2.h>

namespace slipproof {

namespace {

void* const udunits = dlopen("libudunits2.so.0", RTLD_NOW | RTLD_LOCAL);

bool udunits_is_there() {
  return udunits != nullptr;
}

template <class Function>
Function* of_udunits(const char* name) {
  return udunits == nullptr ? nullptr : reinterpret_cast<Function*>(dlsym(udunits, name));
}

#define SLIPPROOF_OF_UDUNITS(name) decltype(::name)* const name = of_udunits<decltype(::name)>(#name)
SLIPPROOF_OF_UDUNITS(cv_convert_double);
SLIPPROOF_OF_UDUNITS(cv_free);
SLIPPROOF_OF_UDUNITS(ut_format);
SLIPPROOF_OF_UDUNITS(ut_free);
SLIPPROOF_OF_UDUNITS(ut_get_converter);
SLIPPROOF_OF_UDUNITS(ut_get_dimensionless_unit_one);
SLIPPROOF_OF_UDUNITS(ut_ignore);
SLIPPROOF_OF_UDUNITS(ut_is_dimensionless);
SLIPPROOF_OF_UDUNITS(ut_multiply);
SLIPPROOF_OF_UDUNITS(ut_divide);
SLIPPROOF_OF_UDUNITS(ut_parse);
SLIPPROOF_OF_UDUNITS(ut_raise);
SLIPPROOF_OF_UDUNITS(ut_read_xml);
SLIPPROOF_OF_UDUNITS(ut_set_error_message_handler);
#undef SLIPPROOF_OF_UDUNITS

}  // namespace

}  // namespace slipproof
