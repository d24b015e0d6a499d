package tellosimulator;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import tellosimulator.control.ControlClient;

/** Tests the program with {@code --control}. */
@Tag("process")
class ControlOptionTest {

  private static final Pattern LINE =
      Pattern.compile("control: 127\\.0\\.0\\.1:(?<port>[0-9]+) token (?<token>[0-9a-f]{32})");

  @Test
  @Timeout(2 * ProgramProcess.PATIENCE_SECONDS)
  void theLineBeforeReadySaysWhereAndWithWhichToken() throws Exception {
    try (ProgramProcess program =
        ProgramProcess.start(
            Main.class, "--headless --time-factor max --control 0 --scenario table-landing", "")) {
      Matcher line = LINE.matcher(program.line());
      assertThat(line.matches()).isTrue();
      int port = program.port();

      try (ControlClient client =
          new ControlClient(Integer.parseInt(line.group("port")), line.group("token"))) {
        assertThat(ProgramProcess.ask("command", port)).isEqualTo("ok");
        assertThat(client.list("journal")).as("what came before the first request").hasSize(1);
        assertThat(client.objects("drones"))
            .singleElement()
            .extracting(drone -> drone.get("commandPort"))
            .isEqualTo(port);
        client.ask("inject", "\"fault\": \"no-valid-imu\"");
        assertThat(ProgramProcess.ask("command", port)).isEqualTo("ok");
        assertThat(ProgramProcess.ask("takeoff", port)).isEqualTo("ok");
        assertThat(client.object("truth")).containsEntry("takeoffs", 1);
        assertThat((List<?>) client.object("goals").get("open")).isNotEmpty();

        client.ask("reset");

        assertThat(client.object("truth")).containsEntry("takeoffs", 0).containsEntry("z", 0.0);
        assertThat(client.list("journal")).isEmpty();
        assertThat(ProgramProcess.ask("command", port)).isEqualTo("ok");
        assertThat(ProgramProcess.ask("truth", port)).as("on the wire").doesNotContain("takeoffs");
      }
      program.type("quit\n");
      assertThat(program.exitCode()).isZero();
    }
  }
}
