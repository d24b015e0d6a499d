# The simulator without a window, as a container. Not yet run in Docker: what the two stages do was
# done by hand in a fresh Debian of the same release, see docs/installation.md.
#
#   docker build -t tello-simulator .
#   docker compose up --exit-code-from program

FROM maven:3-eclipse-temurin-25 AS build
WORKDIR /source
COPY . .
RUN mvn -B -ntp -Papp-image -Dapp-image.installer=false -DskipTests package

FROM debian:bookworm-slim
RUN useradd --system --create-home --home-dir /home/tello tello
COPY --from=build /source/target/app-image/tello-simulator /opt/tello-simulator
USER tello
WORKDIR /home/tello
EXPOSE 8889/udp
ENTRYPOINT ["/opt/tello-simulator/bin/tello-simulator"]
CMD ["--headless", "--lan", "--command-port", "8889"]
