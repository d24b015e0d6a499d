package tellosimulator.fidelity;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** With an invented flight: a takeoff that took much longer than the simulator's, and a landing. */
class FidelityPageTest {

  private static final String LOG =
      """
      100.0\tStation\tcommand
      100.03\tTello\tok
      101.0\tStation\ttakeoff
      101.5\tstate\tpitch:0;roll:0;yaw:5;vgx:0;vgy:0;vgz:0;templ:60;h:0;bat:80;
      105.0\tstate\tpitch:0;roll:0;yaw:7;vgx:2;vgy:0;vgz:0;templ:60;h:80;bat:80;
      111.0\tTello\tok
      111.1\tStation\tland
      115.0\tTello\tok
      """;

  @TempDir private Path folder;

  private Path log(String text) throws IOException {
    return Files.writeString(folder.resolve("log"), text);
  }

  @Test
  void eachCommandIsFlownAndComparedWithTheRealOne() throws IOException {
    String text = FidelityPage.of(FlightLog.read(log(LOG)), folder).text();

    assertThat(text.lines().filter(line -> line.startsWith("| `takeoff` | 10.00 s |")))
        .singleElement()
        .asString()
        .endsWith("| **no** |");
    assertThat(text.lines().filter(line -> line.startsWith("| `land` | 3.90 s |"))).hasSize(1);
    // 2 dm/s at the end, none before: 1 dm/s for 3.5 s, at 5 degrees to the right of yaw 0
    assertThat(text).contains("| `takeoff` | real | 35 | 3 | 80 | 2 |");
  }

  @Test
  void whatIsNoLogIsRefusedWithItsPlace() throws IOException {
    Path file = log("100.0\tStation\tcommand\n100.1\tPilot\tok\n");

    assertThatThrownBy(() -> FlightLog.read(file))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage(file + ":2: expected CommandAddress, Tello or state, found \"Pilot\"");
  }
}
