// expect: the value of an object is an integer, a bool, an enumeration, a float, a double,
#include <jauscat/app/slave.hpp>

void read(const jauscat::slave& drive) {
    drive.async_read<long double>(0x6041, 0, [](boost::system::error_code, long double) {});
}
