// expect: the value of an object is an integer, a bool, an enumeration, a float, a double,
#include <jauscat/app/slave.hpp>

void write(const jauscat::slave& drive) {
    drive.async_write(0x6040, 0, std::vector<int>{6}, [](boost::system::error_code) {});
}
