// The EtherCAT side of the robot controller: one master, its slave, and JAUS messages delivered to it.
#pragma once
#include "support/any_exchange.hpp"
#include "support/cyclic_path.hpp"
#include "support/explain.hpp"
#include "support/link_watch.hpp"
#include "support/trace.hpp"
#include <jauscat/ethercat/packet_job.hpp>
#include <jauscat/jaus/message_sink.hpp>
#include <jauscat/net/run_master.hpp>
#include <jauscat/text/jaus.hpp>
#include <jauscat/text/packet_status.hpp>

#include <memory>
#include <optional>

namespace example {

/// How a slave is worked with.
struct slave_settings {
    jauscat::ethercat::slave_identity slave{};
    std::chrono::milliseconds frame_timeout{20};
    jauscat::ethercat::download_options download{};
    std::chrono::nanoseconds period{};     ///< of the process data; 0: none
    std::chrono::milliseconds watchdog{0}; ///< 0: the slave's own
    std::string trace_name{};              ///< in front of the lines about SDOs on the wire
};

/// Every wait is bounded: a slave that does not answer costs at most `exchange_timeout` once, and is then down until
/// `bring_up` succeeds.
class slave_driver {
  public:
    using bytes = std::span<const std::byte>;
    using clock = std::chrono::steady_clock;

    /// Refers to `link`.
    slave_driver(any_link& link, std::unique_ptr<any_exchange> exchange, const slave_settings& settings, speaker say)
        : link_{link},
          exchange_{std::move(exchange)},
          station_{settings.slave.station},
          download_{settings.download},
          say_{std::move(say)},
          trace_name_{settings.trace_name},
          master_{{.frame_timeout = settings.frame_timeout}} {
        if (settings.period > settings.period.zero())
            cyclic_.emplace(link_, master_, settings.slave, settings.period, settings.watchdog, trace_name_);
    }
    slave_driver(const slave_driver&) = delete;
    slave_driver& operator=(const slave_driver&) = delete;

    /// Whether the slave has answered lately: only then does it get messages.
    [[nodiscard]] bool up() const noexcept { return up_; }
    /// Why it is not.
    [[nodiscard]] std::string problem() const { return explain(master_.result()); }
    [[nodiscard]] std::string place() const {
        return "slave " + std::to_string(station_) + (cyclic_ ? " in OP" : " in PRE-OP");
    }

    /// Tries once to bring the slave to PRE-OP, or to OP for the cyclic path.
    bool bring_up() {
        master_.bring_up(0, station_);
        up_ = static_cast<bool>(jauscat::net::run(link_, master_, exchange_timeout));
        look();
        if (!up_) return false;
        const auto& slave = master_.slaves().front();
        say_("slave " + std::to_string(station_) + " is in PRE-OP: vendor " +
             jauscat::text::hex_number(slave.identity.vendor, 8) + ", product " +
             jauscat::text::hex_number(slave.identity.product, 8));
        if (!cyclic_) return true;
        const auto result = cyclic_->start();
        up_ = static_cast<bool>(result);
        if (up_)
            say_("slave " + std::to_string(station_) + " is in OP");
        else
            say_.bad("no process data: " + explain(result));
        return up_;
    }

    /// To be called at `next_work()` while the slave is up: runs a cycle, or looks whether the slave still answers.
    void work() {
        if (cyclic_) {
            cyclic_->cycle();
            if (!cyclic_->runs()) lose(cyclic_->problem());
        } else if (clock::now() >= next_check_) {
            check();
        }
    }
    [[nodiscard]] clock::time_point next_work() const noexcept {
        return cyclic_ ? cyclic_->next_outputs_by() : next_check_;
    }

    /// Delivers a whole message to the slave; the report, if the message is a query, goes to `out`. True if the slave
    /// has taken the message.
    bool deliver(bytes message, jauscat::jaus::message_sink out) {
        const auto parts = jauscat::jaus::split(message);
        if (!up_) return refuse("slave " + std::to_string(station_) + " does not answer");
        if (cyclic_ && cyclic_->exchange().takes(parts.header)) return exchange_image(parts.header, parts.body, out);
        return exchange_packets(message, out);
    }

  private:
    static constexpr auto exchange_timeout = std::chrono::seconds{2};
    static constexpr auto check_interval = std::chrono::milliseconds{500};
    static constexpr auto repeat_interval = std::chrono::milliseconds{100};
    static constexpr unsigned most_missed_checks = 3;

    bool refuse(const std::string& why) const {
        say_.bad("not delivered: " + why);
        return false;
    }
    void lose(const std::string& why) {
        up_ = false;
        missed_checks_ = 0;
        say_.bad("slave " + std::to_string(station_) + " " + why);
    }
    void look() { watch_.look(master_, link_, say_); }

    // A slave that was switched off and on again has lost its station address.
    void check() {
        using namespace jauscat::ethercat;
        std::array<std::byte, jauscat::wire::max_size<al_status>> answer{};
        al_status status{};
        master_.exchange(command::fprd, station_, esc_registers::al_status.address, answer);
        const auto result = jauscat::net::run(link_, master_, exchange_timeout);
        look();
        next_check_ = clock::now() + (result ? check_interval : repeat_interval);
        if (!result) { // once or twice: a busy machine holds frames up
            if (++missed_checks_ == most_missed_checks) lose("does not answer: " + explain(result));
            return;
        }
        missed_checks_ = 0;
        if (result.detail != 1) // the working counter
            lose("is no longer there under its station address");
        else if (jauscat::wire::decode_prefix(status, answer) && status.state == al_state::init)
            lose("is in INIT");
    }

    // A command into the outputs or a query out of the inputs. A command that asks for an acknowledgement has arrived
    // when the slave's inputs say so: that takes a cycle or two.
    bool exchange_image(const jauscat::jaus::header& head, bytes body, jauscat::jaus::message_sink out) {
        auto& exchange = cyclic_->exchange();
        const auto now = [] { return clock::now().time_since_epoch(); };
        if (head.command_code != exchange.command_code) {
            std::array<std::byte, any_exchange::buffer_size> report{};
            const auto size =
                exchange.template on_query<jauscat::jaus::query_wrench_effort>(head, body, cyclic_->inputs(), report);
            if (size == 0) return refuse("the query is malformed");
            say_("answers from the process image: " + jauscat::text::hex(cyclic_->inputs()));
            out(bytes{report}.first(size));
            return true;
        }
        const auto error = exchange.on_command(head, body, cyclic_->outputs(), cyclic_->inputs(), now());
        if (error != jauscat::translate::errc::ok) return refuse(std::string{describe(error)});
        say_("into the process image, command " + std::to_string(exchange.given(cyclic_->outputs())) + ": " +
             jauscat::text::hex(cyclic_->outputs()));
        if (head.ack_nak != jauscat::jaus::ack_nak::request) return true;
        std::array<std::byte, jauscat::jaus::header_size> answer{};
        while (exchange.acknowledgement(cyclic_->inputs(), now(), answer) == 0) cyclic_->cycle(); // a second at most
        const bool taken = jauscat::jaus::split(answer).header.ack_nak == jauscat::jaus::ack_nak::ack;
        return taken || refuse("the slave has not taken the command out of its process data");
    }

    bool exchange_packets(bytes message, jauscat::jaus::message_sink out) {
        using enum jauscat::ethercat::exchange_progress;
        std::array<std::byte, any_exchange::buffer_size> buffer{};
        auto step = exchange_->begin(message, buffer);
        if (step.what == request)
            say_("translated to an SDO download packet", packet_text(bytes{buffer}.first(step.size)));
        while (step.what == request) {
            const auto confirmation = execute(bytes{buffer}.first(step.size));
            step = exchange_->on_confirmation(confirmation, buffer);
            if (step.what == request)
                say_("asks for the report by an SDO upload packet, " + upload_text(bytes{buffer}.first(step.size)));
        }
        if (step.what != done)
            return refuse(exchange_->error() != jauscat::translate::errc::ok
                              ? std::string{describe(exchange_->error())}
                              : jauscat::text::explain(exchange_->status()));
        if (step.size != 0) out(bytes{buffer}.first(step.size));
        return true;
    }

    /// Executes a request packet and returns its confirmation.
    bytes execute(bytes request) {
        jauscat::ethercat::packet_job job{request, confirmation_, {.download = download_}};
        while (cyclic_ && cyclic_->busy()) cyclic_->cycle(); // one datagram's time
        traced_link traced{link_, trace_name_};
        for (bool runs = job.start(master_); runs; runs = job.next(master_))
            static_cast<void>(cyclic_ ? cyclic_->run_job(exchange_timeout)
                                      : jauscat::net::run(traced, master_, exchange_timeout));
        const auto result = job.result();
        if (!result) {
            say_.bad("EtherCAT: " + explain(result));
            using enum jauscat::ethercat::master_errc;
            if (result.error != sdo_abort && result.error != clear_refused && result.error != mailbox_error &&
                result.error != data_too_long)
                lose("is taken for lost");
        }
        look();
        return bytes{confirmation_}.first(job.finish(result));
    }

    any_link& link_;
    std::unique_ptr<any_exchange> exchange_;
    std::uint16_t station_;
    jauscat::ethercat::download_options download_;
    speaker say_;
    std::string trace_name_;
    jauscat::ethercat::master master_;
    link_watch watch_{};
    std::optional<cyclic_path> cyclic_{};
    bool up_{};
    clock::time_point next_check_{};
    unsigned missed_checks_{}; ///< in a row
    std::array<std::byte, jauscat::ethercat::packet_job::confirmation_size> confirmation_{};
};

} // namespace example
