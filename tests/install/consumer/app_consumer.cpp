// A node on the API for applications, in two sources.
#include <jauscat/app.hpp>
#include <jauscat/net.hpp>

#include <exception>

int components_of(jauscat::node& node);

int main() try {
    jauscat::node node{{.config_text = "<jausconfig thissystem='a'><system><name>a</name><jausip>1.0.0.0</jausip>"
                                       "<ip>127.0.0.1</ip><port>39777</port></system></jausconfig>"}};
    return components_of(node) == 1 ? 0 : 1;
} catch (const std::exception&) {
    return 1;
}
