// No table of units: each unit is unknown, and nothing is said about units.
#pragma once
struct ut_system {};
struct ut_unit {};
struct cv_converter {};
inline int ut_ignore(const char*, ...) {
  return 0;
}
using ut_error_message_handler = int (*)(const char*, ...);
enum { UT_ASCII = 0, UT_DEFINITION = 1, UT_UTF8 = 2 };
inline ut_error_message_handler ut_set_error_message_handler(ut_error_message_handler handler) {
  return handler;
}
inline ut_system* ut_read_xml(const char*) {
  return nullptr;
}
inline void ut_free(ut_unit*) {}
inline ut_unit* ut_get_dimensionless_unit_one(const ut_system*) {
  return nullptr;
}
inline ut_unit* ut_multiply(const ut_unit*, const ut_unit*) {
  return nullptr;
}
inline ut_unit* ut_divide(const ut_unit*, const ut_unit*) {
  return nullptr;
}
inline ut_unit* ut_raise(const ut_unit*, int) {
  return nullptr;
}
inline ut_unit* ut_parse(const ut_system*, const char*, int) {
  return nullptr;
}
inline int ut_is_dimensionless(const ut_unit*) {
  return 0;
}
inline int ut_format(const ut_unit*, char*, unsigned, unsigned) {
  return -1;
}
inline cv_converter* ut_get_converter(ut_unit*, ut_unit*) {
  return nullptr;
}
inline void cv_free(cv_converter*) {}
inline double cv_convert_double(const cv_converter*, double value) {
  return value;
}
