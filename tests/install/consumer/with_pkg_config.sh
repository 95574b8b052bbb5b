#!/bin/sh
# with_pkg_config.sh CONSUMER [compiled]: builds the programs of the folder CONSUMER in the working folder, at the prompt as it were.
set -eu
cp "$1"/*.cpp .
# shellcheck disable=SC2046 # pkg-config prints words
if [ "${2:-}" = compiled ]; then
# [compiled]
g++ -std=c++20 app_consumer.cpp app_part.cpp $(pkg-config --cflags --libs jauscat-compiled) -o compiled_consumer
g++ -std=c++20 catalogue_consumer.cpp $(pkg-config --cflags --libs jauscat-catalogue) -o catalogue_consumer
g++ -std=c++20 sae_consumer.cpp $(pkg-config --cflags --libs jauscat-catalogue-sae) -o sae_consumer
# [compiled end]
else
# [build]
g++ -std=c++20 codec_consumer.cpp $(pkg-config --cflags --libs jauscat) -o codec_consumer
g++ -std=c++20 text_consumer.cpp $(pkg-config --cflags --libs jauscat) -o text_consumer
g++ -std=c++20 esi_consumer.cpp $(pkg-config --cflags --libs jauscat-esi) -o esi_consumer
g++ -std=c++20 net_consumer.cpp $(pkg-config --cflags --libs jauscat-net) -o net_consumer
# [build end]
fi
