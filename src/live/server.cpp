// The only source that includes Boost.Beast.
#include "access.hpp"
#include "message_table.hpp"
#include "page.hpp"
#include "state_json.hpp"
#include <jauscat/net/bind_error.hpp>
#include <jauscat/net/live/live_server.hpp>
#include <jauscat/net/now.hpp>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <deque>
#include <fstream>
#include <functional>
#include <list>
#include <mutex>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <sys/resource.h>
#include <thread>
#include <unistd.h>
#include <utility> // before the first header of Asio 1.74, which uses std::exchange without it
#include <vector>

namespace jauscat::net {

namespace live {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using asio::ip::tcp;
using error_code = boost::system::error_code;
using json = nlohmann::ordered_json;
using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr milliseconds read_interval{10}; ///< of the feeds
constexpr int reads_of_update = 10;
constexpr std::size_t max_header = 8192; ///< bytes of a request
constexpr std::size_t max_input = 1024;  ///< bytes of a text of a viewer
constexpr std::size_t max_connections = 32;
constexpr int updates_to_close = 20;
constexpr seconds old_state{2}; ///< a node gives it ten times a second
constexpr int default_send_buffer = 256 * 1024;

static std::string dumped(const json& value) { return value.dump(-1, ' ', false, json::error_handler_t::replace); }

struct fault_line {
    std::uint64_t number{}; ///< from 1
    double at{};
    live_level level{};
    std::string text{};
};

/// What viewers get, besides messages, as JSON; and the update that it has changed in last.
struct part {
    std::string text{};
    std::uint64_t changed{};

    void set(std::string now, std::uint64_t update) {
        if (now == text) return;
        text = std::move(now);
        changed = update;
    }
};

/// A viewer. Its connection is closed when it sends more than `max_input` bytes in one text.
class viewer : public std::enable_shared_from_this<viewer> {
  public:
    explicit viewer(beast::tcp_stream stream) : stream_{std::move(stream)} {}

    void accept(const http::request<http::string_body>& request, std::function<void()> accepted,
                std::function<void()> ended) {
        ended_ = std::move(ended);
        beast::get_lowest_layer(stream_).expires_never();
        stream_.set_option(websocket::stream_base::timeout::suggested(beast::role_type::server));
        stream_.read_message_max(max_input);
        stream_.auto_fragment(false);
        stream_.async_accept(request, [self = shared_from_this(), accepted = std::move(accepted)](error_code error) {
            if (error) return self->end();
            self->is_open_ = true;
            self->read();
            accepted();
        });
    }
    /// False: an earlier text is not sent yet.
    bool send(std::string text) {
        if (!is_open_ || is_writing_) return false;
        is_writing_ = true;
        text_ = std::move(text);
        stream_.text(true);
        stream_.async_write(asio::buffer(text_), [self = shared_from_this()](error_code error, std::size_t) {
            self->is_writing_ = false;
            if (error) self->end();
        });
        return true;
    }
    [[nodiscard]] bool is_open() const noexcept { return is_open_; }
    /// At each update: a viewer that does not answer the end of its connection keeps no place.
    void check() {
        if (is_open_ && !stream_.is_open() && ++closing_ == updates_to_close) beast::get_lowest_layer(stream_).close();
    }
    [[nodiscard]] bool is_writing() const noexcept { return is_writing_; }

    std::optional<std::uint64_t> seen{}; ///< the last update that was sent
    std::uint64_t seen_fault{};
    std::uint64_t skipped{};

  private:
    /// What it sends is ignored.
    void read() {
        stream_.async_read(input_, [self = shared_from_this()](error_code error, std::size_t) {
            if (error) return self->end();
            self->input_.consume(self->input_.size());
            self->read();
        });
    }
    void end() {
        is_open_ = false;
        if (const auto ended = std::exchange(ended_, nullptr)) ended();
    }

    websocket::stream<beast::tcp_stream> stream_;
    beast::flat_buffer input_{};
    std::string text_{};
    bool is_open_{}, is_writing_{};
    int closing_{}; ///< updates since the connection was to end
    std::function<void()> ended_{};
};

} // namespace live

using namespace live;

/// All but the feeds and the faults belongs to its thread.
class live_server::worker {
  public:
    explicit worker(live_options options) : options_{std::move(options)} {
        read_page();
        open();
        const bool is_local = acceptor_.local_endpoint().address().is_loopback();
        if (!options_.token.empty() && !is_token(options_.token))
            throw std::invalid_argument{"a token of the live view has 8 to 128 letters, digits, '-' and '_'"};
        if (options_.token.empty() && !is_local) options_.token = random_token();
        const auto endpoint = acceptor_.local_endpoint();
        port_ = endpoint.port();
        const auto address = endpoint.address();
        const auto host = address.is_v6() ? "[" + address.to_string() + "]" : address.to_string();
        link_ = "http://" + host + ":" + std::to_string(port_) + "/";
        if (!options_.token.empty()) link_ += "?token=" + options_.token;
    }
    ~worker() {
        context_.stop();
        if (thread_.joinable()) thread_.join();
        viewers_.clear(); // their sockets end before their io_context
        for (auto* const feed : feeds_) feed->set_watched(false);
    }
    worker(const worker&) = delete;
    worker& operator=(const worker&) = delete;

    void add(live_feed& feed) {
        feeds_.push_back(&feed);
        states_.emplace_back();
        state_times_.emplace_back();
    }
    void start() {
        accept();
        sigset_t all{}, before{};
        sigfillset(&all); // signals are for the program's own threads
        pthread_sigmask(SIG_SETMASK, &all, &before);
        thread_ = std::thread{[this] { run(); }};
        pthread_sigmask(SIG_SETMASK, &before, nullptr);
    }

    [[nodiscard]] const std::string& link() const noexcept { return link_; }
    [[nodiscard]] std::uint16_t port() const noexcept { return port_; }
    void fault(live_level level, std::string_view line) {
        const std::scoped_lock lock{mutex_};
        faults_.push_back({++last_fault_, seconds_at(now()), level, std::string{line}});
        if (faults_.size() > max_faults) faults_.pop_front();
    }
    [[nodiscard]] live_counts counts() const {
        return {.viewers = viewer_count_, .lost = lost_, .skipped = skipped_, .updates = updates_, .refused = refused_};
    }

  private:
    using request = http::request<http::string_body>;
    /// A connection until it is a viewer's.
    struct connection {
        explicit connection(tcp::socket socket) : stream{std::move(socket)} {}
        beast::tcp_stream stream;
        beast::flat_buffer buffer{max_header + max_input};
        std::optional<http::request_parser<http::string_body>> parser{};
        http::response<http::string_body> response{};
    };
    using connection_ptr = std::shared_ptr<connection>;

    void read_page() {
        page_ = live::page();
        if (options_.page_file.empty()) return;
        std::ifstream file{options_.page_file, std::ios::binary};
        std::ostringstream text;
        if (!(text << file.rdbuf())) // a folder, too, where a read throws
            throw std::invalid_argument{"the page of the live view cannot be read: " + options_.page_file};
        page_ = text.str();
    }
    void open() {
        error_code error;
        const auto& text = options_.address;
        const auto address = asio::ip::make_address(text == "localhost" ? "127.0.0.1" : text, error);
        if (error)
            throw open_error{
                {.code = errc::invalid_address, .reason = error, .message = "'" + text + "' is no IP address"}};
        const tcp::endpoint at{address, options_.port};
        acceptor_.open(at.protocol(), error);
        if (!error) acceptor_.set_option(tcp::acceptor::reuse_address{true}, error);
        if (!error) acceptor_.bind(at, error);
        if (!error) acceptor_.listen(asio::socket_base::max_listen_connections, error);
        if (error)
            throw open_error{
                bind_error(error, "the live view cannot listen on TCP " + text + ":" + std::to_string(options_.port),
                           options_.port, "-ltnp")};
    }

    void run() {
        // The threads of the program come first. On Linux this is of this thread alone.
        static_cast<void>(::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), 10));
        for (;;) {
            try {
                context_.run();
                return;
            } catch (const std::exception& error) { // the program works on
                fault(live_level::warning, std::string{"the live view: "} + error.what());
            }
        }
    }

    void accept() {
        acceptor_.async_accept([this](error_code error, tcp::socket socket) {
            if (error == asio::error::operation_aborted) return;
            if (error) { // such as too many open files
                retry_.expires_after(seconds{1});
                return retry_.async_wait([this](error_code) { accept(); });
            }
            if (connections_ < max_connections) {
                error_code ignored;
                socket.set_option(tcp::no_delay{true}, ignored);
                const auto buffer = options_.send_buffer != 0 ? options_.send_buffer : default_send_buffer;
                socket.set_option(asio::socket_base::send_buffer_size{buffer}, ignored);
                read_request(connection_ptr{new connection{std::move(socket)}, [this](connection* one) {
                                                --connections_;
                                                delete one;
                                            }});
                ++connections_;
            }
            accept();
        });
    }

    void read_request(const connection_ptr& from) {
        from->parser.emplace();
        from->parser->header_limit(max_header);
        from->parser->body_limit(max_input);
        from->stream.expires_after(seconds{10});
        http::async_read(from->stream, from->buffer, *from->parser, [this, from](error_code error, std::size_t) {
            if (error == http::error::header_limit || error == http::error::body_limit ||
                error == http::error::buffer_overflow)
                return answer(from, http::status::payload_too_large, "The request is too long.\n");
            if (!error) on_request(from, from->parser->get());
        });
    }

    void on_request(const connection_ptr& from, const request& asked) {
        const auto text = [&](http::field name) {
            const auto value = asked[name];
            return std::string_view{value.data(), value.size()};
        };
        const auto target = split_target({asked.target().data(), asked.target().size()});
        const auto refused =
            why_refused({.host = text(http::field::host), .origin = text(http::field::origin), .token = target.token},
                        options_.token);
        if (!refused.empty()) {
            ++refused_;
            return answer(from, http::status::forbidden, std::string{refused});
        }
        if (target.path == "/live" && websocket::is_upgrade(asked)) return begin_viewer(from, asked);
        if (target.path != "/")
            return answer(from, http::status::not_found, "There is nothing here: the page is at /.\n");
        if (asked.method() != http::verb::get && asked.method() != http::verb::head)
            return answer(from, http::status::method_not_allowed, "The live view is for reading only: GET.\n");
        answer(from, http::status::ok, page_, "text/html; charset=utf-8");
    }

    static void answer(const connection_ptr& to, http::status status, std::string body,
                       const char* type = "text/plain; charset=utf-8") {
        auto& response = to->response;
        response.result(status);
        response.set(http::field::content_type, type);
        response.set(http::field::cache_control, "no-store");
        response.set(http::field::x_frame_options, "DENY");
        response.set("X-Content-Type-Options", "nosniff");
        response.set("Referrer-Policy", "no-referrer");
        response.keep_alive(false);
        response.body() = std::move(body);
        response.prepare_payload();
        if (to->parser->is_header_done() && to->parser->get().method() == http::verb::head) response.body().clear();
        to->stream.expires_after(seconds{30});
        http::async_write(to->stream, response, [to](error_code, std::size_t) {
            error_code ignored;
            to->stream.socket().shutdown(tcp::socket::shutdown_send, ignored);
        });
    }

    void begin_viewer(const connection_ptr& from, const request& asked) {
        if (viewers_.size() == max_viewers)
            return answer(from, http::status::service_unavailable, "There are 8 viewers already.\n");
        const auto one = std::make_shared<viewer>(std::move(from->stream));
        const auto at = viewers_.insert(viewers_.end(), one);
        one->accept(
            asked, [this] { begin_updates(); },
            [this, at] {
                viewers_.erase(at);
                viewer_count_ = viewers_.size();
            });
        viewer_count_ = viewers_.size();
    }

    void begin_updates() {
        if (std::exchange(is_updating_, true)) return;
        for (auto* const feed : feeds_) feed->set_watched(true);
        for (auto& time : state_times_)
            if (time) time = now(); // nobody has asked for it meanwhile
        table_.resume();
        reads_ = 0;
        next_read_ = std::chrono::steady_clock::now();
        wait_for_read();
    }
    void wait_for_read() {
        next_read_ = std::max(next_read_ + read_interval, std::chrono::steady_clock::now());
        timer_.expires_at(next_read_);
        timer_.async_wait([this](error_code error) {
            if (error) return;
            if (viewers_.empty()) {
                for (auto* const feed : feeds_) feed->set_watched(false);
                is_updating_ = false;
                return;
            }
            wait_for_read();
            read_feeds();
            if (++reads_ % reads_of_update == 0) update();
        });
    }
    void read_feeds() {
        for (auto* const feed : feeds_) {
            auto& samples = feed->samples();
            // At most all that there is now: a flood does not keep the viewers waiting.
            for (std::size_t left = net::detail::sample_ring::capacity; left != 0; --left) {
                const auto* const sample = samples.begin_read();
                if (sample == nullptr) break;
                table_.add(*sample);
                samples.end_read();
            }
        }
    }
    void update() {
        table_.end_update();
        take_states();
        std::uint64_t lost = table_.lost();
        for (auto* const feed : feeds_) lost += feed->samples().lost();
        lost_ = lost;
        for (const auto& one : viewers_) {
            one->check();
            if (!one->is_open()) continue;
            if (one->is_writing()) {
                ++one->skipped;
                ++skipped_;
            } else if (one->send(frame_for(*one))) {
                ++updates_;
            }
        }
    }
    void take_states() {
        bool is_new = false;
        for (std::size_t i = 0; i != feeds_.size(); ++i)
            if (auto state = feeds_[i]->take_state()) {
                states_[i] = *std::move(state);
                state_times_[i] = now();
                is_new = true;
            }
        if (!is_new) return;
        json systems = json::array(), components = json::array(), buses = json::array();
        std::vector<live_system> shown; // several nodes of one program have the same configuration
        for (const auto& state : states_) {
            for (const auto& one : state.systems)
                if (std::ranges::find(shown, one) == shown.end()) {
                    shown.push_back(one);
                    systems.push_back(to_json(one));
                }
            for (const auto& one : state.components) components.push_back(to_json(one));
            for (const auto& one : state.buses) buses.push_back(to_json(one));
        }
        systems_.set(dumped(systems), table_.update());
        components_.set(dumped(components), table_.update());
        buses_.set(dumped(buses), table_.update());
    }

    /// Sets what the viewer has seen.
    std::string frame_for(viewer& one) {
        const bool is_first = !one.seen;
        const auto seen = one.seen.value_or(0);
        json head{{"at", seconds_at(now())}, {"lost", lost_.load()}, {"skipped", one.skipped}};
        if (is_first)
            head["hello"] = {{"program", options_.program},
                             {"version", options_.version},
                             {"name", options_.name},
                             {"period", std::chrono::duration<double>{read_interval * reads_of_update}.count()}};
        if (const auto age = state_age(); age > old_state)
            head["state_age"] = std::chrono::duration_cast<seconds>(age).count();
        if (auto faults = faults_since(one.seen_fault); !faults.empty()) head["faults"] = std::move(faults);
        std::string text = dumped(head);
        text.pop_back();
        const auto append = [&](const char* name, const std::string& value) {
            ((((text += ",\"") += name) += "\":") += value);
        };
        if (systems_.changed > seen) append("systems", systems_.text);
        if (components_.changed > seen) append("components", components_.text);
        if (buses_.changed > seen) append("buses", buses_.text);
        if (const auto rows = table_.rows_since(seen); !rows.empty()) append("messages", rows);
        one.seen = table_.update();
        return text += '}';
    }
    /// Of the oldest state that is shown: the thread of its node may hang.
    [[nodiscard]] duration state_age() const {
        duration oldest{};
        for (const auto& time : state_times_)
            if (time) oldest = std::max(oldest, now() - *time);
        return oldest;
    }
    json faults_since(std::uint64_t& seen) {
        json made = json::array();
        const std::scoped_lock lock{mutex_};
        constexpr std::array names{"info", "warning", "bad"};
        for (const auto& one : faults_)
            if (one.number > seen)
                made.push_back(
                    {{"at", one.at}, {"level", names[static_cast<std::size_t>(one.level)]}, {"text", one.text}});
        seen = last_fault_;
        return made;
    }
    [[nodiscard]] double seconds_at(time_point at) const {
        return static_cast<double>(std::chrono::duration_cast<milliseconds>(at - begin_).count()) / 1000;
    }

    live_options options_;
    time_point begin_{now()};
    std::string page_{};
    std::string link_{};
    std::uint16_t port_{};
    std::vector<live_feed*> feeds_{};
    std::vector<live_state> states_{}; ///< the last one of each feed
    std::vector<std::optional<time_point>> state_times_{};
    message_table table_{options_.messages, options_.sae_messages, begin_};
    part systems_{}, components_{}, buses_{};

    std::mutex mutex_{};
    std::deque<fault_line> faults_{};
    std::uint64_t last_fault_{};

    std::atomic<std::size_t> viewer_count_{};
    std::atomic<std::uint64_t> lost_{}, skipped_{}, updates_{}, refused_{};

    std::size_t connections_{};
    std::list<std::shared_ptr<viewer>> viewers_{};
    asio::io_context context_{1}; ///< its handlers refer to the members above
    tcp::acceptor acceptor_{context_};
    asio::steady_timer timer_{context_}, retry_{context_};
    std::chrono::steady_clock::time_point next_read_{};
    int reads_{};
    bool is_updating_{};
    std::thread thread_{};
};

live_server::live_server(live_options options) : worker_{std::make_unique<worker>(std::move(options))} {}
live_server::~live_server() = default;
void live_server::add(live_feed& feed) { worker_->add(feed); }
void live_server::start() { worker_->start(); }
const std::string& live_server::link() const noexcept { return worker_->link(); }
std::uint16_t live_server::port() const noexcept { return worker_->port(); }
void live_server::fault(live_level level, std::string_view line) { worker_->fault(level, line); }
live_counts live_server::counts() const { return worker_->counts(); }

} // namespace jauscat::net
