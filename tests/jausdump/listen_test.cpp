// Messages from a UDP port, as they arrive.
#include "program.hpp"
#include "support/catch.hpp"

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ip/udp.hpp>
#include <boost/asio/write.hpp>

#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <thread>

namespace {

using boost::asio::ip::udp;
using dump_test::from_hex;
using dump_test::status;

/// jausdump, listening at a port that the system chose.
class listening_program {
  public:
    explicit listening_program(std::vector<std::string> arguments, std::uint16_t port = 0,
                               const std::string& said = "listening on UDP port ") {
        arguments.insert(arguments.begin(), {dump_test::jausdump(), "--listen", std::to_string(port)});
        pid_ = ::fork();
        if (pid_ == 0) {
            redirect(out_, STDOUT_FILENO);
            redirect(err_, STDERR_FILENO);
            std::vector<char*> words;
            for (auto& word : arguments) words.push_back(word.data());
            words.push_back(nullptr);
            ::execv(arguments.front().c_str(), words.data());
            ::_exit(127);
        }
        port_ = static_cast<std::uint16_t>(std::stoi(wait_for(err_, said + "N", [&](const std::string& text) {
            const auto at = text.find(said);
            return at == std::string::npos || text.find_first_of(";:", at) == std::string::npos
                       ? std::string{}
                       : text.substr(at + said.size());
        })));
    }
    listening_program(const listening_program&) = delete;
    listening_program& operator=(const listening_program&) = delete;
    ~listening_program() {
        if (pid_ > 0) end(SIGKILL);
    }

    void send(const std::string& hex) {
        const auto bytes = from_hex(hex);
        socket_.send_to(boost::asio::buffer(bytes), {boost::asio::ip::address_v4::loopback(), port_});
    }
    void wait_for_output(const std::string& awaited) const {
        wait_for(out_, awaited, [&](const std::string& text) {
            return text.find(awaited) == std::string::npos ? std::string{} : text;
        });
    }
    /// The exit code.
    int end(int signal) {
        ::kill(pid_, signal);
        int ended = 0;
        ::waitpid(std::exchange(pid_, -1), &ended, 0);
        return WIFEXITED(ended) ? WEXITSTATUS(ended) : -1;
    }
    [[nodiscard]] std::string output() const { return dump_test::content(out_); }

  private:
    static void redirect(const std::string& path, int descriptor) {
        ::dup2(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), descriptor);
    }
    template <class Find> static std::string wait_for(const std::string& path, const std::string& what, Find find) {
        for (int i = 0; i != 600; ++i) {
            if (auto found = find(dump_test::content(path)); !found.empty()) return found;
            std::this_thread::sleep_for(std::chrono::milliseconds{50});
        }
        throw std::runtime_error{"not said within 30 seconds: " + what};
    }

    dump_test::scratch files_{};
    std::string out_{files_ / "out"}, err_{files_ / "err"};
    pid_t pid_{-1};
    std::uint16_t port_{};
    boost::asio::io_context context_{};
    udp::socket socket_{context_, udp::v4()};
};

const std::string prefix = "4a41555330312e30";

} // namespace

TEST_CASE("messages at a port are shown on arrival, until Ctrl-C prints the summary") {
    listening_program program{{}};
    program.send(status);
    program.wait_for_output("Report Component Status");
    program.send("ff");
    program.send(prefix + "0602 0748 01200101 01250101 0310 0000 01 02 aa");
    program.send(prefix + "0602 0748 01200101 01250101 0180 0100 bb");
    program.wait_for_output("image_data = 2 bytes: aa bb");
    REQUIRE(program.end(SIGINT) == 0);
    const auto text = program.output();
    REQUIRE(text.find(
                "4 messages: 2 decoded, 2 packets of large data sets\n1 skipped: not JAUS: shorter than a header\n") !=
            std::string::npos);
}

TEST_CASE("messages at a port are shown as JSON with the sender's address; an unknown one makes the exit code 1") {
    listening_program program{{"--format", "json"}};
    program.send(prefix + status);
    program.send("8602 15e0 01260598 01040182 0000 0000");
    program.wait_for_output("0xE015");
    REQUIRE(program.end(SIGTERM) == 1);
    std::istringstream lines{program.output()};
    std::string line;
    REQUIRE(std::getline(lines, line));
    const auto object = dump_test::json::parse(line);
    REQUIRE(object.at("message") == "Report Component Status");
    REQUIRE(object.at("origin").at("packet") == 1);
    REQUIRE(object.at("origin").at("from").get<std::string>().starts_with("127.0.0.1:"));
    REQUIRE(object.at("origin").at("time").get<std::string>().size() == 27);
}

TEST_CASE("messages at a port are written as a capture that shows the same, and is whole after each of them") {
    const dump_test::scratch files;
    const auto file = files / "port.pcap";
    listening_program program{{"--format", "json", "--write", file}};
    program.send(prefix + status);
    program.send("ff");
    program.send("02 00 1100 01 06050400 03020100 0d0023 0700");
    program.wait_for_output("RequestControl");
    REQUIRE(program.end(SIGINT) == 0);
    std::vector<dump_test::json> shown, read = dump_test::run("--format json " + file).objects();
    std::istringstream lines{program.output()};
    for (std::string line; std::getline(lines, line);) shown.push_back(dump_test::json::parse(line));
    REQUIRE(shown.size() == 2);
    for (auto* all : {&shown, &read})
        for (auto& object : *all) object.at("origin").erase("packet");
    REQUIRE(read == shown);

    listening_program killed{{"--write", file}};
    killed.send(status);
    killed.send(status);
    const auto written = [&] { return dump_test::run("--format json " + file).lines().size(); };
    for (int i = 0; i != 600 && written() != 2; ++i) std::this_thread::sleep_for(std::chrono::milliseconds{50});
    killed.end(SIGKILL);
    REQUIRE(written() == 2);
}

TEST_CASE("messages of SAE JAUS and of the RA at one port are shown on arrival") {
    listening_program program{{"--format", "json"}};
    program.send("02 00 1100 01 06050400 03020100 0d0023 0700");
    program.send(status);
    program.wait_for_output("\"packet\":2");
    REQUIRE(program.end(SIGINT) == 0);
    std::istringstream lines{program.output()};
    std::vector<dump_test::json> shown;
    for (std::string line; std::getline(lines, line);) shown.push_back(dump_test::json::parse(line));
    REQUIRE(shown.size() == 2);
    CHECK(shown[0].at("message") == "RequestControl");
    CHECK(shown[0].at("fields") == dump_test::json{{"authority_code", 35}});
    CHECK(shown[0].at("origin").at("from").get<std::string>().starts_with("127.0.0.1:"));
    CHECK(shown[1].at("message") == "Report Component Status");
}

TEST_CASE("messages of a running program are captured where it has the port") {
    boost::asio::io_context context;
    const auto loopback = boost::asio::ip::address_v4::loopback();
    udp::socket node{context, udp::endpoint{loopback, 0}}, peer{context, udp::endpoint{loopback, 0}};
    const auto port = node.local_endpoint().port();
    if (::geteuid() != 0) {
        const auto refused = dump_test::run("--listen " + std::to_string(port));
        REQUIRE(refused.code == 2);
        REQUIRE(refused.err.find("udp port " + std::to_string(port) + " | jausdump -") != std::string::npos);
        return;
    }
    listening_program program{{"--format", "json"}, port, "another program has UDP port "};
    const auto send = [](udp::socket& from, const udp::socket& to, const std::string& hex) {
        const auto bytes = from_hex(hex);
        from.send_to(boost::asio::buffer(bytes), to.local_endpoint());
    };
    send(peer, node, status);
    send(node, peer, status);
    program.wait_for_output("\"packet\":2");
    send(peer, peer, status); // of no interest
    send(peer, node, status);
    program.wait_for_output("\"packet\":3");
    REQUIRE(program.end(SIGINT) == 0);
    std::istringstream lines{program.output()};
    std::vector<dump_test::json> shown;
    for (std::string line; std::getline(lines, line);) shown.push_back(dump_test::json::parse(line));
    REQUIRE(shown.size() == 3);
    const auto text = [&](const udp::socket& of) { return "127.0.0.1:" + std::to_string(of.local_endpoint().port()); };
    REQUIRE(shown[0]["origin"]["from"] == text(peer));
    REQUIRE(shown[0]["origin"]["to"] == text(node));
    REQUIRE(shown[1]["origin"]["from"] == text(node));
    std::vector<std::byte> received(100);
    REQUIRE(node.receive(boost::asio::buffer(received)) == 21); // and the program gets them all
}

TEST_CASE("TCP streams of a running program are captured where it has the port") {
    if (::geteuid() != 0) return; // the test above shows what is said then
    using boost::asio::ip::tcp;
    boost::asio::io_context context;
    const auto loopback = boost::asio::ip::address_v4::loopback();
    udp::socket node{context, udp::endpoint{loopback, 0}};
    const auto port = node.local_endpoint().port();
    tcp::acceptor acceptor{context, tcp::endpoint{loopback, port}};
    listening_program program{{"--format", "json"}, port, "another program has UDP port "};
    tcp::socket peer{context};
    peer.connect(acceptor.local_endpoint());
    tcp::socket accepted = acceptor.accept();
    boost::asio::write(peer, boost::asio::buffer(from_hex("02 00 1100 01 06050400 03020100 0d")));
    boost::asio::write(peer, boost::asio::buffer(from_hex("0023 0700")));
    program.wait_for_output("RequestControl");
    REQUIRE(program.end(SIGINT) == 0);
    std::istringstream lines{program.output()};
    std::string line;
    REQUIRE(std::getline(lines, line));
    CHECK(dump_test::json::parse(line).at("origin").at("to") == "127.0.0.1:" + std::to_string(port));
    CHECK_FALSE(std::getline(lines, line));
}
