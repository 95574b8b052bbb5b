// Messages of any size handed to a sink: the standard has 25 whose size has no bound.
#include "jaus/messages.hpp"
#include <jauscat/jaus/component/answer.hpp>
#include <jauscat/schema/jaus/environment_sensor.hpp>

using namespace jauscat;
using namespace jauscat::test;

namespace {

constexpr jaus::header query{.destination = {1, 33, 2, 2}, .source = {1, 32, 1, 1}, .sequence_number = 7};
constexpr jaus::address camera{1, 33, 2, 2};

bytes picture(std::size_t size) {
    bytes made(size);
    for (std::size_t i = 0; i != size; ++i) made[i] = static_cast<std::byte>(i * 7);
    return made;
}

} // namespace

TEST_CASE("a message of unbounded size is sent like one of bounded size") {
    const auto data = picture(10);
    sent_messages sent;
    const auto out = sent.sink();
    REQUIRE(jaus::answer(query, camera, jaus::report_image{.camera_id = 1, .image_data = data}, out));
    REQUIRE(sent.size() == 1);
    CHECK(sent.header(0).source == camera);
    CHECK(sent.header(0).data_size == 12);
    CHECK(to_hex(std::span{sent[0]}.subspan(jaus::header_size)) == "01 00 " + to_hex(data));
}

TEST_CASE("without memory a body of 4080 bytes is sent and a larger one is not") {
    sent_messages sent;
    const auto out = sent.sink();
    const auto data = picture(4080);
    jaus::report_image image{.image_data = std::span{data}.first(4078)};
    REQUIRE(jaus::put(query, image, out));
    REQUIRE(sent[0].size() == 4096);
    image.image_data = data;
    REQUIRE(jaus::put(query, image, out).error() == jaus::errc::body_too_large);
    REQUIRE(sent.size() == 1);
}

TEST_CASE("with memory a larger body is sent as a large data set") {
    sent_messages sent;
    const auto out = sent.sink();
    const auto data = picture(10'000);
    const jaus::report_image image{.camera_id = 3, .image_data = data};
    bytes memory(4096 + 10'002);
    REQUIRE(jaus::answer(query, camera, image, memory, out));
    REQUIRE(sent.size() == 3);
    bytes whole;
    for (std::size_t i = 0; i != sent.size(); ++i) {
        CHECK(sent.header(i).sequence_number == i);
        CHECK(sent.header(i).command_code == jaus::command_code_of<jaus::report_image>);
        whole.insert(whole.end(), sent[i].begin() + jaus::header_size, sent[i].end());
    }
    CHECK(sent.header(0).data_flag == jaus::data_flag::first);
    CHECK(sent.header(2).data_flag == jaus::data_flag::last);
    CHECK(whole.size() == 10'002);
    CHECK(std::ranges::equal(std::span{whole}.subspan(2), data));

    sent.clear();
    memory.pop_back();
    REQUIRE(jaus::answer(query, camera, image, memory, out).error() == jaus::errc::no_space);
    REQUIRE(sent.empty());
}
