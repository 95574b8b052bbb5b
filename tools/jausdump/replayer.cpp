#include "replayer.hpp"

#include "capture_writer.hpp"
#include "number_text.hpp"
#include "support/output.hpp"
#include <jauscat/net/detail/endpoint_text.hpp>

#include <charconv>
#include <iostream>
#include <thread>
#include <unistd.h>

namespace jausdump {

namespace {

using boost::asio::ip::udp;
namespace error = boost::asio::error;

/// The address of "10.0.0.2:3794", "robot:3794" or "[::1]:3794".
udp::endpoint resolve(boost::asio::io_context& context, const std::string& target) {
    const auto colon = target.rfind(':');
    std::string host = target.substr(0, colon);
    const std::string port = colon == std::string::npos ? std::string{} : target.substr(colon + 1);
    std::uint16_t number{};
    const auto [end, problem] = std::from_chars(port.data(), port.data() + port.size(), number);
    if (host.empty() || problem != std::errc{} || end != port.data() + port.size() || number == 0)
        throw input_error{"--replay must be HOST:PORT with a port of 1 to 65535, not '" + target + "'"};
    const bool is_v6 = host.front() == '[' && host.back() == ']';
    if (is_v6) host = host.substr(1, host.size() - 2);
    boost::system::error_code failed;
    udp::resolver resolver{context};
    const auto found = resolver.resolve(is_v6 ? udp::v6() : udp::v4(), host, port, failed);
    if (failed || found.empty()) throw input_error{"--replay " + target + ": " + failed.message()};
    return found.begin()->endpoint();
}

std::string counted(std::size_t count, const std::string& what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

} // namespace

replayer::replayer(const std::string& target, double speed, std::function<bool()> stop)
    : speed_{speed}, stop_{std::move(stop)}, shows_progress_{::isatty(STDERR_FILENO) == 1} {
    const auto to = resolve(context_, target);
    target_ = jauscat::net::detail::text(to);
    boost::system::error_code failed;
    socket_.open(to.protocol());
    socket_.set_option(boost::asio::socket_base::broadcast{true});
    socket_.connect(to, failed); // so that a closed port is reported
    if (failed) throw input_error{"--replay " + target + ": " + failed.message()};
}

void replayer::follow(options& how) {
    how.quiet = true;
    how.on_message = [this] { has_message_ = true; };
}

void replayer::follow(capture_listener& listener) {
    listener.datagram = [this, pass_on = std::move(listener.datagram)](auto payload, const auto& from) {
        pass_on(payload, from);
        if (std::exchange(has_message_, false) || is_part_of_message(payload))
            on_datagram(payload, from.time.value_or(std::chrono::nanoseconds{}));
        else
            ++passed_over_;
    };
    listener.tcp = [this, pass_on = std::move(listener.tcp)](const auto& segment, const auto& from) {
        pass_on(segment, from);
        of_tcp_ += std::exchange(has_message_, false) ? 1 : 0;
    };
    listener.serial = [this, pass_on = std::move(listener.serial)](auto part, const auto& from) {
        pass_on(part, from);
        of_serial_ += std::exchange(has_message_, false) ? 1 : 0;
    };
    listener.progress = [this](double part) { part_ = part; };
}

void replayer::on_datagram(std::span<const std::byte> payload, std::chrono::nanoseconds time) {
    wait_for(time);
    is_stopped_ = stop_();
    if (is_stopped_) return;
    send(payload);
    show_progress();
}

void replayer::wait_for(std::chrono::nanoseconds time) {
    if (!begun_) {
        begun_ = steady::now();
        first_ = time;
    }
    if (speed_ == 0) return;
    constexpr std::chrono::milliseconds longest{100}; // Ctrl-C ends it
    const std::chrono::duration<double> since_first = time - first_;
    for (;;) {
        const std::chrono::duration<double> rest = since_first / speed_ - (steady::now() - *begun_);
        if (rest.count() <= 0 || stop_()) return;
        show_progress();
        if (rest < longest)
            std::this_thread::sleep_for(rest);
        else
            std::this_thread::sleep_for(longest);
    }
}

void replayer::send(std::span<const std::byte> payload) {
    boost::system::error_code failed;
    // What a send reports may be the refusal of a datagram before: this one was not sent then.
    for (int attempts = 2; attempts != 0; --attempts) {
        socket_.send(boost::asio::buffer(payload.data(), payload.size()), 0, failed);
        if (!failed) {
            ++sent_;
            bytes_ += payload.size();
            return;
        }
        if (failed == error::message_size) {
            ++too_large_;
            return;
        }
        note_refusal(failed);
    }
}

void replayer::note_refusal(const boost::system::error_code& failed) {
    if (failed != error::connection_refused && failed != error::host_unreachable &&
        failed != error::network_unreachable)
        throw std::runtime_error{"sending to " + target_ + ": " + failed.message()};
    if (refused_++ == 0)
        std::cerr << (shows_progress_ ? "\r\033[K" : "") << "jausdump: " << target_ << ": " << failed.message()
                  << (failed == error::connection_refused ? ": no program receives there" : "")
                  << "; sending goes on\n";
}

void replayer::show_progress() {
    if (!shows_progress_ || steady::now() - shown_ < std::chrono::milliseconds{200}) return;
    shown_ = steady::now();
    std::cerr << "\rreplaying: " << static_cast<int>(part_ * 100) << " %, " << counted(sent_, "datagram") << std::flush;
}

bool replayer::finish(bool as_json) {
    if (shows_progress_) std::cerr << "\r\033[K" << std::flush;
    is_stopped_ = is_stopped_ || stop_();
    boost::asio::detail::socket_option::integer<SOL_SOCKET, SO_ERROR> last{};
    boost::system::error_code failed;
    socket_.get_option(last, failed); // the refusal of the last datagram
    if (!failed && last.value() != 0) note_refusal({last.value(), boost::system::system_category()});
    const std::chrono::duration<double> time = begun_ ? steady::now() - *begun_ : steady::duration{};
    if (sent_ == 0 && too_large_ == 0 && refused_ == 0 && !is_stopped_)
        throw std::runtime_error{
            "nothing to send: the capture has no datagram with a message of JAUS that passes the "
            "filters" +
            std::string{of_tcp_ + of_serial_ != 0 ? "; messages of TCP streams and serial lines are not sent" : ""}};
    if (as_json) {
        std::cout << json{{"sent", sent_},       {"bytes", bytes_},         {"seconds", time.count()},
                          {"refused", refused_}, {"too_large", too_large_}, {"passed_over", passed_over_},
                          {"tcp", of_tcp_},      {"serial", of_serial_},    {"stopped", is_stopped_}}
                         .dump()
                  << "\n";
    } else {
        std::cout << counted(sent_, "datagram") << " (" << counted(bytes_, "byte") << ") sent to " << target_ << " in "
                  << fixed_text(time.count(), 3) << " s" << (is_stopped_ ? ", stopped before the end" : "") << "\n";
        const auto tell = [](std::size_t count, const std::string& what, const std::string& why) {
            if (count != 0) std::cout << counted(count, what) << why << "\n";
        };
        if (refused_ != 0)
            std::cout << "at least " << counted(refused_, "datagram") << " refused: closed port, or not reachable\n";
        tell(too_large_, "datagram", " not sent: too large for the network");
        tell(passed_over_, "datagram", " passed over: not JAUS, or not chosen by the filters");
        tell(of_tcp_, "segment", " of TCP with messages not sent: only datagrams are");
        tell(of_serial_, "packet", " of serial lines with messages not sent: only datagrams are");
    }
    example::require_output();
    return refused_ == 0 && too_large_ == 0 && !is_stopped_;
}

} // namespace jausdump
