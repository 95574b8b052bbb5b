// Error codes that name their subject.
#pragma once
#include <jauscat/base/compilation.hpp>

#include <boost/system/error_code.hpp>

#include <cstdint>
#include <string>

namespace jauscat {
inline namespace JAUSCAT_WAY {
namespace app {

/// A category of the library's errors. Boost compares categories by their number, so that an error with a text of its
/// own equals the error without.
class known_category : public boost::system::error_category {
  public:
    [[nodiscard]] std::uint64_t number() const noexcept { return number_; }

  protected:
    explicit known_category(std::uint64_t number) noexcept : error_category{number}, number_{number} {}

  private:
    std::uint64_t number_;
};

/// The same error, with this text as its message: what it is about, and the reason. Of a category of the library; any
/// other is returned as it is. A text is kept for good: 4,096 of them at most, later errors come without.
[[nodiscard]] JAUSCAT_DECL boost::system::error_code explained(const boost::system::error_code& error,
                                                               const std::string& text);

} // namespace app
} // namespace JAUSCAT_WAY
} // namespace jauscat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/app/impl/explained.ipp>
#endif
