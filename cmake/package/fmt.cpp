// SPDX-License-Identifier: BSD-3-Clause
// fmt's own functions as an archive, for programs that run where its shared library is not: Debian has no static
// one. Which templates must be instantiated is said by fmt's src/format.cc (version 9, MIT); a missing one fails to link.
#include <fmt/format-inl.h>

FMT_BEGIN_NAMESPACE
namespace detail {
template dragonbox::decimal_fp<float> dragonbox::to_decimal(float x) noexcept;
template dragonbox::decimal_fp<double> dragonbox::to_decimal(double x) noexcept;
template std::locale locale_ref::get<std::locale>() const;
template thousands_sep_result<char> thousands_sep_impl(locale_ref);
template char decimal_point_impl(locale_ref);
template void buffer<char>::append(const char*, const char*);
}  // namespace detail
FMT_END_NAMESPACE
