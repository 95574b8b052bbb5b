// A table of objects by SDO: the downloads that a message becomes, and the uploads that a report is made of.
#pragma once
#include <jauscat/base/result.hpp>
#include <jauscat/ethercat/cia402/pdo_layout.hpp>
#include <jauscat/ethercat/master/jobs.hpp>
#include <jauscat/translate/object_table.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>

namespace jauscat::bridging {

/// Where the objects of an axis are.
struct axis_address {
    std::uint16_t station{}; ///< of its drive
    std::size_t axis{};      ///< of the drive, from 0: adds 800h to the index for each
};

/// An object with an address, as those of cia402_objects.hpp.
template <class T>
concept addressed_object = requires(const T& object) {
    { object.index_of(std::size_t{}) } -> std::same_as<std::uint16_t>;
    { object.subindex } -> std::convertible_to<std::uint8_t>;
};

namespace detail {

template <class Table> struct object_rows;
template <class Message, class Scale, class... Rows>
struct object_rows<translate::object_table<Message, Scale, Rows...>> {
    static_assert((addressed_object<std::remove_cvref_t<decltype(Rows::object)>> && ...),
                  "object_jobs: an object of the table has no index_of and subindex");
    static constexpr std::size_t count = sizeof...(Rows);
    static constexpr std::size_t largest = std::max({sizeof(typename Rows::value_type)...});
};

} // namespace detail

/// The downloads for a message that `Table`, an object_table, maps to objects of `Axes` axes.
template <class Table, std::size_t Axes> class object_downloads {
    using rows = detail::object_rows<Table>;

  public:
    using scales = std::span<const typename Table::scale_type, Axes>;

    object_downloads() noexcept = default;
    object_downloads(const object_downloads&) = delete;
    object_downloads& operator=(const object_downloads&) = delete;

    /// Makes the downloads; returns the axes for which a limit is used in place of the message's value. Errors, with no
    /// downloads: those of object_translator::to_objects.
    result<translate::axis_bits, translate::errc> make(std::span<const std::byte> body, scales parameters,
                                                       std::span<const axis_address, Axes> where) noexcept {
        count_ = 0;
        return translate::object_translator<Table>::to_objects(
            body, parameters, [&](std::size_t axis, const auto& object, auto value) {
                auto& data = data_[count_];
                cia402::store(cia402::pdo_place{0, sizeof(value) * 8}, data, value);
                jobs_[count_++] = {.station = where[axis].station,
                                   .index = object.index_of(where[axis].axis),
                                   .subindex = object.subindex,
                                   .data = std::span{data}.first(sizeof(value))};
            });
    }
    /// One for each row and axis: row by row, from axis 1. Their data are in this object.
    [[nodiscard]] std::span<const ethercat::download> jobs() const noexcept { return std::span{jobs_}.first(count_); }

  private:
    std::array<ethercat::download, rows::count * Axes> jobs_{};
    std::array<std::array<std::byte, rows::largest>, rows::count * Axes> data_{};
    std::size_t count_{};
};

/// The uploads for a report that `Table`, an object_table, makes of objects of `Axes` axes.
template <class Table, std::size_t Axes> class object_uploads {
    using rows = detail::object_rows<Table>;

  public:
    using scales = std::span<const typename Table::scale_type, Axes>;

    explicit object_uploads(std::span<const axis_address, Axes> where) noexcept {
        std::size_t next = 0;
        Table::for_rows([&]<class Row>(Row) {
            for (const auto& each : where) {
                jobs_[next] = {.station = each.station,
                               .index = Row::object.index_of(each.axis),
                               .subindex = Row::object.subindex,
                               .into = std::span{data_[next]}.first(sizeof(typename Row::value_type))};
                ++next;
            }
        });
    }
    object_uploads(const object_uploads&) = delete;
    object_uploads& operator=(const object_uploads&) = delete;

    /// One for each row and axis: row by row, from axis 1. They fill this object.
    [[nodiscard]] std::span<const ethercat::upload> jobs() const noexcept { return jobs_; }
    /// A job has ended: `read` is its result, or 0 bytes after an error.
    void on_read(std::size_t job, std::span<const std::byte> read) noexcept {
        is_read_[job] = read.size() == jobs_[job].into.size();
    }
    /// Writes the message to `body`, and returns it; the values have to be read anew for the next one. Errors:
    /// wrong_size (an object has not been read, or has another size), no_space.
    [[nodiscard]] result<std::span<std::byte>, translate::errc> report(scales parameters,
                                                                       std::span<std::byte> body) noexcept {
        const bool is_whole = std::ranges::find(is_read_, false) == is_read_.end();
        is_read_.fill(false); // also after a failure: a report has values of one reading
        if (!is_whole) return translate::errc::wrong_size;
        return translate::object_translator<Table>::from_objects(
            [&, next = std::size_t{}]<class Object>(std::size_t, const Object&) mutable {
                using value_type = typename Object::value_type;
                return cia402::load<value_type>(cia402::pdo_place{0, sizeof(value_type) * 8}, data_[next++]);
            },
            parameters, body);
    }

  private:
    std::array<std::array<std::byte, rows::largest>, rows::count * Axes> data_{};
    std::array<ethercat::upload, rows::count * Axes> jobs_{};
    std::array<bool, rows::count * Axes> is_read_{};
};

} // namespace jauscat::bridging
