// What works while a node runs, besides its components.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/schema/jaus/header.hpp>

namespace jauscat {
inline namespace JAUSCAT_WAY {
namespace app {

class node_part {
  public:
    node_part() = default;
    virtual ~node_part() = default;
    node_part(const node_part&) = delete;
    node_part& operator=(const node_part&) = delete;

    /// The node has started.
    virtual void start() = 0;
    /// The node will stop: its messages still go out.
    virtual void stop() noexcept = 0;
    /// One of its components has this ID.
    [[nodiscard]] virtual bool has(const jaus::address& component) const = 0;
};

} // namespace app
} // namespace JAUSCAT_WAY
} // namespace jauscat
