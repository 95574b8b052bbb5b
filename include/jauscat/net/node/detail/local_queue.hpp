// Queue of messages between components of one program: delivered when the sending component has returned.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace jauscat::net::detail {

/// Holds up to `most` bytes. Its memory grows as needed, and is reused.
class local_queue {
  public:
    explicit local_queue(std::size_t most) : most_{most} {}

    /// False, without a change, if it is full.
    bool push(std::uint16_t component, std::span<const std::byte> message) {
        if (message.size() > most_ - waiting_.bytes.size()) return false;
        waiting_.bytes.insert(waiting_.bytes.end(), message.begin(), message.end());
        waiting_.messages.push_back({component, message.size()});
        return true;
    }
    [[nodiscard]] bool empty() const noexcept { return waiting_.messages.empty(); }

    /// Calls `use(component, bytes)` for each queued message, not for those pushed meanwhile. Not from within `use`.
    void hand_on(auto&& use) {
        std::swap(waiting_, current_);
        waiting_.clear();
        std::size_t at = 0;
        for (const auto& [component, size] : current_.messages) {
            use(component, std::span<const std::byte>{current_.bytes}.subspan(at, size));
            at += size;
        }
    }
    void clear() noexcept { waiting_.clear(); }

  private:
    struct entry {
        std::uint16_t component{};
        std::size_t size{};
    };
    struct batch {
        std::vector<std::byte> bytes{};
        std::vector<entry> messages{};
        void clear() noexcept {
            bytes.clear();
            messages.clear();
        }
    };
    std::size_t most_;
    batch waiting_{}, current_{};
};

} // namespace jauscat::net::detail
