package tellosimulator;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Tests the program with {@code web}, {@code board} and {@code --board}. */
@Tag("process")
class WebOptionTest {

  private static final HttpClient CLIENT = HttpClient.newHttpClient();

  private static String page(String link) throws IOException, InterruptedException {
    HttpRequest request = HttpRequest.newBuilder(URI.create(link)).build();
    return CLIENT.send(request, HttpResponse.BodyHandlers.ofString()).body();
  }

  @Test
  @Timeout(2 * ProgramProcess.PATIENCE_SECONDS)
  void theWordWebPrintsTheLinkOfThePage() throws Exception {
    try (ProgramProcess program =
        ProgramProcess.with(
            "web 0 --bind 127.0.0.1 --command-port 0 --control 0 --scenario gate-race")) {
      String line = program.line();
      assertThat(line).matches("web: http://127\\.0\\.0\\.1:[0-9]+/\\?token=[0-9a-f]{32}");
      assertThat(program.line()).startsWith("control: ");
      program.port();

      assertThat(page(line.replaceFirst("web: ", ""))).contains("<html lang=");

      program.type("quit\n");
      assertThat(program.exitCode()).isZero();
    }
  }

  @Test
  @Timeout(3 * ProgramProcess.PATIENCE_SECONDS)
  void simulatorsReportToTheBoard() throws Exception {
    try (ProgramProcess board = ProgramProcess.with("board --port 0")) {
      String link = board.line().replaceFirst("web: ", "");
      String forClass = board.line().replaceFirst("board: ", "");
      try (ProgramProcess program =
          ProgramProcess.start(Main.class, "--headless --name Ada --board " + forClass, "")) {
        program.port();

        HttpRequest state =
            HttpRequest.newBuilder(URI.create(link.replace("/?", "/state?"))).build();
        try (var lines = CLIENT.send(state, HttpResponse.BodyHandlers.ofLines()).body()) {
          assertThat(lines.anyMatch(line -> line.contains("\"Ada\""))).isTrue();
        }
        program.type("quit\n");
        assertThat(program.exitCode()).isZero();
      }
      board.type("quit\n");
      assertThat(board.exitCode()).isZero();
    }
  }
}
