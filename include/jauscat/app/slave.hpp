// A slave of a bus: its objects, its states.
#pragma once
#include <jauscat/app/bus_options.hpp>
#include <jauscat/app/object_value.hpp>
#include <jauscat/schema/ethercat/error_counters.hpp>
#include <jauscat/schema/ethercat/sdo_information.hpp>

#include <boost/asio/io_context.hpp>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace jauscat {
inline namespace JAUSCAT_WAY {
namespace app {
class bus_state;
}

/// Description of an object, as the slave has it.
struct object_information {
    ethercat::object_answer object{};
    std::string name{};
};
/// Description of an entry of an object, as the slave has it. A value that the slave has not sent is empty.
struct entry_information {
    ethercat::entry_answer entry{};
    std::string name{};
    std::optional<std::uint32_t> unit{}; ///< unit type, as in ETG.1004
    std::vector<std::byte> default_value{};
    std::vector<std::byte> minimum{};
    std::vector<std::byte> maximum{};
};

/// A handle of a slave, copied like a pointer. It may be used before the slave is found and after it was lost: each
/// operation looks the slave up. See bus for what holds for all operations; those of objects have the errors
/// slave_lost, no_objects, not_taken, no_answer, refused, malformed_answer, and abort codes.
///
///     auto drive = bus.slave({.position = 2});
///     co_await drive.async_write(0x6060, 0, std::int8_t{9});
///     auto word = co_await drive.async_read<std::uint16_t>(0x6041, 0);
class slave {
  public:
    slave(std::shared_ptr<app::bus_state> bus, const slave_choice& which) : bus_{std::move(bus)}, which_{which} {}
    slave(const slave&) = default; // also where it is moved: there is no handle without a bus
    slave& operator=(const slave&) = default;
    ~slave() = default;

    /// Reads an object: an integer, a bool (1 byte), an enumeration, a float or a double of exactly its size
    /// (wrong_size), a std::string (VISIBLE_STRING; zeros at its end are not part of it) or a std::vector<std::byte>
    /// (any). Up to 65,536 bytes (too_large). `void(error_code, T)`.
    template <class T, class Token = default_token>
    auto async_read(std::uint16_t index, std::uint8_t subindex, Token&& token = Token{}) const {
        if constexpr (app::require_object_value<T>())
            return boost::asio::async_initiate<Token, void(app::error_code, T)>(
                [](auto handler, const slave& self, std::uint16_t i, std::uint8_t s) {
                    self.read(i, s, app::object_type_of<T>(),
                              app::make_operation<app::object_bytes>(std::move(handler), app::object_conversion<T>{},
                                                                     self.executor()));
                },
                token, *this, index, subindex);
    }
    /// Writes an object: a value of the types of `async_read`, or anything that converts to a std::string_view or a
    /// std::span<const std::byte>. The type decides how many bytes are written: `std::int8_t{9}`, not 9. In segments if
    /// they do not fit the mailbox. After an error other than an abort code the object may have been written.
    /// `void(error_code)`.
    template <class T, class Token = default_token>
    auto async_write(std::uint16_t index, std::uint8_t subindex, const T& value, Token&& token = Token{}) const {
        return boost::asio::async_initiate<Token, void(app::error_code)>(
            // NOLINTNEXTLINE(performance-unnecessary-value-param): it is moved on
            [](auto handler, const slave& self, std::uint16_t i, std::uint8_t s, app::object_bytes bytes) {
                self.write(i, s, std::move(bytes),
                           app::make_operation<>(std::move(handler), app::no_conversion{}, self.executor()));
            },
            token, *this, index, subindex, app::to_object(value));
    }

    /// Indices of all objects, or of those of a list. `void(error_code, std::vector<std::uint16_t>)`.
    template <class Token = default_token>
    auto async_list_objects(ethercat::object_list_type list = ethercat::object_list_type::all,
                            Token&& token = Token{}) const {
        return boost::asio::async_initiate<Token, void(app::error_code, std::vector<std::uint16_t>)>(
            [](auto handler, const slave& self, ethercat::object_list_type which) {
                self.list_objects(which, app::make_operation<std::vector<std::uint16_t>>(
                                             std::move(handler), app::no_conversion{}, self.executor()));
            },
            token, *this, list);
    }
    /// `void(error_code, object_information)`.
    template <class Token = default_token> auto async_describe(std::uint16_t index, Token&& token = Token{}) const {
        return boost::asio::async_initiate<Token, void(app::error_code, object_information)>(
            [](auto handler, const slave& self, std::uint16_t i) {
                self.describe(i, app::make_operation<object_information>(std::move(handler), app::no_conversion{},
                                                                         self.executor()));
            },
            token, *this, index);
    }
    /// `void(error_code, entry_information)`.
    template <class Token = default_token>
    auto async_describe_entry(std::uint16_t index, std::uint8_t subindex, Token&& token = Token{}) const {
        return boost::asio::async_initiate<Token, void(app::error_code, entry_information)>(
            [](auto handler, const slave& self, std::uint16_t i, std::uint8_t s) {
                self.describe_entry(
                    i, s,
                    app::make_operation<entry_information>(std::move(handler), app::no_conversion{}, self.executor()));
            },
            token, *this, index, subindex);
    }

    /// Reads the state that the slave is in. Errors: slave_lost. `void(error_code, ethercat::al_status)`.
    template <class Token = default_token> auto async_state(Token&& token = Token{}) const {
        return boost::asio::async_initiate<Token, void(app::error_code, ethercat::al_status)>(
            [](auto handler, const slave& self) {
                self.state(app::make_operation<ethercat::al_status>(std::move(handler), app::no_conversion{},
                                                                    self.executor()));
            },
            token, *this);
    }
    /// Reads how many errors the slave's controller has counted at its ports. Errors: slave_lost.
    /// `void(error_code, ethercat::error_counters)`.
    template <class Token = default_token> auto async_error_counters(Token&& token = Token{}) const {
        return boost::asio::async_initiate<Token, void(app::error_code, ethercat::error_counters)>(
            [](auto handler, const slave& self) {
                self.error_counters(app::make_operation<ethercat::error_counters>(
                    std::move(handler), app::no_conversion{}, self.executor()));
            },
            token, *this);
    }
    /// Takes the slave to INIT, PRE-OP or SAFE-OP, step by step; on the way to SAFE-OP its process data are configured.
    /// An error of the slave is acknowledged. To OP: `async_operate` (needs_cycles). A slave in operation is brought to
    /// rest first, by outputs of zeros. Errors: slave_lost, served,
    /// state_not_reached, not_configurable, AL status codes. `void(error_code)`.
    template <class Token = default_token> auto async_change(ethercat::al_state goal, Token&& token = Token{}) const {
        return boost::asio::async_initiate<Token, void(app::error_code)>(
            [](auto handler, const slave& self, ethercat::al_state to) {
                self.change(to, app::make_operation<>(std::move(handler), app::no_conversion{}, self.executor()));
            },
            token, *this, goal);
    }

    /// Takes the slave to OP, and exchanges its process data in each cycle from then on: from outputs of zeros, with
    /// its watchdog. What they consist of is written before, in PRE-OP, or the slave's default. In OP until
    /// `async_change` or the end of the bus, which first set all outputs to zero, or until it is lost: it has left OP,
    /// has not exchanged its process data for the options' timeout, or was reset. Then `bus::when_lost` gets the
    /// reason, and `bus::when_found` tells that it answers again; it is not taken to OP by itself, because a device
    /// that was exchanged or reset may have other process data. Throws `std::invalid_argument` for options out of
    /// range. Errors: slave_lost, served, state_not_reached, not_configurable, not_synchronized, AL status
    /// codes. `void(error_code)`.
    template <class Token = default_token>
    auto async_operate(const operate_options& options = {}, Token&& token = Token{}) const {
        return boost::asio::async_initiate<Token, void(app::error_code)>(
            [](auto handler, const slave& self, const operate_options& how) {
                self.operate(how, app::make_operation<>(std::move(handler), app::no_conversion{}, self.executor()));
            },
            token, *this, options);
    }
    /// Whether the slave is in OP by `async_operate` and exchanges its process data.
    [[nodiscard]] JAUSCAT_DECL bool is_operating() const;
    /// The outputs that the next cycle sends, and the inputs of the last one; empty where the slave is not operating.
    /// For use until the return from the callback or handler; with a thread of the bus in `bus::every_cycle` only.
    [[nodiscard]] JAUSCAT_DECL std::span<std::byte> outputs() const;
    [[nodiscard]] JAUSCAT_DECL std::span<const std::byte> inputs() const;
    /// Whether the last cycle has brought the inputs. If not, they are those of an earlier one.
    [[nodiscard]] JAUSCAT_DECL bool has_current_inputs() const;
    /// Since the frame with the inputs was sent; the highest value where there are none.
    [[nodiscard]] JAUSCAT_DECL duration input_age() const;

    /// What the bus knows of the slave, which it has found. Errors: not_started, no_such_slave, ambiguous.
    [[nodiscard]] JAUSCAT_DECL slave_info info(boost::system::error_code& error) const;
    /// Throws `boost::system::system_error`.
    [[nodiscard]] JAUSCAT_DECL slave_info info() const;
    [[nodiscard]] const slave_choice& choice() const noexcept { return which_; }

    /// For the classes of this folder.
    [[nodiscard]] const std::shared_ptr<app::bus_state>& bus() const noexcept { return bus_; }

  private:
    [[nodiscard]] JAUSCAT_DECL boost::asio::any_io_executor executor() const noexcept;
    JAUSCAT_DECL void read(std::uint16_t index, std::uint8_t subindex, const app::object_type& type,
                           app::operation_ptr<app::object_bytes> done) const;
    JAUSCAT_DECL void write(std::uint16_t index, std::uint8_t subindex, app::object_bytes bytes,
                            app::operation_ptr<> done) const;
    JAUSCAT_DECL void list_objects(ethercat::object_list_type list,
                                   app::operation_ptr<std::vector<std::uint16_t>> done) const;
    JAUSCAT_DECL void describe(std::uint16_t index, app::operation_ptr<object_information> done) const;
    JAUSCAT_DECL void describe_entry(std::uint16_t index, std::uint8_t subindex,
                                     app::operation_ptr<entry_information> done) const;
    JAUSCAT_DECL void state(app::operation_ptr<ethercat::al_status> done) const;
    JAUSCAT_DECL void error_counters(app::operation_ptr<ethercat::error_counters> done) const;
    JAUSCAT_DECL void change(ethercat::al_state goal, app::operation_ptr<> done) const;
    JAUSCAT_DECL void operate(const operate_options& options, app::operation_ptr<> done) const;

    std::shared_ptr<app::bus_state> bus_;
    slave_choice which_;
};

} // namespace JAUSCAT_WAY
} // namespace jauscat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/app/impl/slave.ipp>
#endif
