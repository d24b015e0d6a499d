package tellosimulator.web;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.headless.HeadlessSimulator;
import tellosimulator.network.AddressPlan;
import tellosimulator.recording.RecordingFolder;
import tellosimulator.scenario.Gallery;
import tellosimulator.sim.Control;
import tellosimulator.testing.ChromiumPage;
import tellosimulator.testing.HeadlessSimulators;
import tellosimulator.testing.NeedsTool;
import tellosimulator.testing.Tool;

/** The pages in a real browser, with real keys and drags. */
@NeedsTool(Tool.CHROMIUM)
@Timeout(value = 120, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
final class PageInBrowserTest {

  private static final InetAddress LOOPBACK = InetAddress.getLoopbackAddress();

  /** A scenario whose texts would be scripts, if they were markup; its goal is to fly forward. */
  private static final String ATTACK =
      """
      name: "<img src=x onerror=document.title='attacked'>"
      teaches: "<script>document.title='attacked'</script>"
      room: {width: 600, depth: 600, height: 300}
      goals:
      - reach: {at: [60, 0, 30], radius: 50, points: 5}
      """;

  @TempDir private Path folder;
  private HeadlessSimulator simulator;
  private String link;
  private ChromiumPage page;

  @BeforeEach
  void open() throws Exception {
    simulator =
        HeadlessSimulators.of(Gallery.find("gate-race").orElseThrow(), AddressPlan.ofMachine(3, 0));
    simulator.record(
        RecordingFolder.at(Files.createDirectory(folder.resolve("flights"))), List.of());
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    simulator.openWeb(
        new InetSocketAddress(LOOPBACK, 0), new PrintStream(out, true, StandardCharsets.UTF_8));
    simulator.switchOn();
    link = out.toString(StandardCharsets.UTF_8).strip().replaceFirst("web: ", "");
    page = new ChromiumPage(folder, 1200, 900);
  }

  @AfterEach
  void close() {
    page.close();
    simulator.close();
  }

  private Object text(String id) throws Exception {
    return page.value("document.getElementById('" + id + "').textContent");
  }

  private void awaitText(String id, String part) throws Exception {
    page.await("document.getElementById('" + id + "').textContent.includes(`" + part + "`)");
  }

  @Test
  void somebodyFliesAnUploadedScenarioByKeysAndReadsTheScore() throws Exception {
    page.open(link);
    page.await("document.getElementById('room').naturalWidth > 400");
    page.await("document.getElementById('film').naturalWidth === 960");
    awaitText("title", "Gate race");

    Path scenario = Files.writeString(folder.resolve("mine.yaml"), ATTACK);
    page.click("#open-gallery");
    page.await("document.querySelectorAll('#scenarios button').length === 10");
    page.choose("#upload", scenario);
    awaitText("title", "<img src=x onerror=document.title='attacked'>");
    awaitText("teaches", "<script>document.title='attacked'</script>");
    assertThat(page.value("document.title")).asString().doesNotStartWith("attacked");

    page.click("#keyboard");
    page.press("Space");
    page.release("Space");
    awaitText("last", "takeoff → ok");
    page.press("KeyW");
    awaitText("banner", "All goals are reached");
    page.release("KeyW");
    awaitText("score", "5 of 5 points");
    page.press("Space");
    page.release("Space");
    awaitText("last", "land → ok");

    assertThat(text("log")).asString().contains("took off").contains("landed");
    assertThat(text("problem")).isEqualTo("");
    page.await("document.getElementById('report').hasAttribute('href')");
    page.open((String) page.value("document.getElementById('report').href"));
    page.await("document.body.innerText.includes('takeoff')");
  }

  @Test
  void aKeyThatIsReleasedCentersTheStick() throws Exception {
    page.open(link);
    page.await("document.getElementById('room').naturalWidth > 400");
    page.click("#keyboard");
    page.press("Space");
    page.release("Space");
    awaitText("last", "takeoff → ok");

    page.press("ArrowRight");
    page.await("state.drones[0].heading > 20");
    page.release("ArrowRight");

    page.await("sent.command === CENTERED && !steering");
    long still = simulator.current().simulation().snapshot().time().nanos() + 1_000_000_000;
    while (simulator.current().simulation().snapshot().time().nanos() < still) {
      Thread.onSpinWait();
    }
    double heading = heading();
    still += 500_000_000;
    while (simulator.current().simulation().snapshot().time().nanos() < still) {
      Thread.onSpinWait();
    }
    assertThat(heading()).isCloseTo(heading, within(0.01));
  }

  @Test
  void aSimulatorThatEndsIsNoticed() throws Exception {
    page.open(link);
    awaitText("title", "Gate race");

    simulator.close();

    awaitText("problem", "The simulator does not answer.");
  }

  @Test
  void aDragTurnsTheRoomAndKeysChooseViews() throws Exception {
    page.open(link);
    page.await("document.getElementById('room').naturalWidth > 400");
    simulator.current().simulation().carryOut(new Control.Pause(true));
    awaitText("pause", "Go on");
    String start = changed("");

    page.drag("#room", 80, 20);
    String turned = changed(start);
    page.press("Digit3");
    page.release("Digit3");
    String top = changed(turned);
    page.press("Digit4");
    page.release("Digit4");
    changed(top);
  }

  private double heading() {
    return simulator
        .current()
        .simulation()
        .snapshot()
        .drones()
        .get(0)
        .state()
        .motion()
        .attitude()
        .heading();
  }

  /** Waits until the room looks different, and stays so; returns the sum of its pixels. */
  private String changed(String before) throws Exception {
    String sum =
        "(() => { const c = document.createElement('canvas'); c.width = 64; c.height = 36;"
            + " const g = c.getContext('2d'); g.drawImage(room, 0, 0, 64, 36);"
            + " return g.getImageData(0, 0, 64, 36).data.reduce((a, b) => (a * 31 + b) % 1e9); })()";
    page.await("String(" + sum + ") !== '" + before + "'");
    String now = String.valueOf(page.value(sum));
    String next = String.valueOf(page.value("new Promise(r => setTimeout(r, 300)) && " + sum));
    while (!now.equals(next)) {
      now = next;
      next = String.valueOf(page.value(sum));
    }
    return now;
  }

  @Test
  void thePageIsGermanAndFitsAPhone() throws Exception {
    page.call(
        "Emulation.setDeviceMetricsOverride",
        Map.of("width", 360, "height", 780, "deviceScaleFactor", 2, "mobile", true));
    page.open(link + "&language=de");

    awaitText("takeoff", "Abheben");
    awaitText("title", "Torrennen");
    page.await("room.naturalWidth > 0 && film.naturalWidth > 0");
    assertThat((Number) page.value("document.documentElement.scrollWidth"))
        .satisfies(width -> assertThat(width.intValue()).isLessThanOrEqualTo(360));
  }

  @Test
  void everyControlHasANameForScreenReaders() throws Exception {
    page.open(link);
    awaitText("title", "Gate race");

    assertThat(
            page.value(
                "[...document.querySelectorAll('button, select, input, a.button, img')]"
                    + ".filter(e => !(e.textContent.trim() || e.ariaLabel || e.alt"
                    + " || e.closest('label'))).map(e => e.outerHTML).join()"))
        .isEqualTo("");
  }

  @Test
  void theBoardShowsWhatSimulatorsReportAsText() throws Exception {
    try (WebServer board = WebServer.board(new InetSocketAddress(LOOPBACK, 0))) {
      URI forClass = URI.create(board.lines().get(1).replaceFirst("board: ", ""));
      String name = "<img src=x onerror=document.title='attacked'>";
      BoardReporter reporter = BoardReporter.start(simulator, forClass, name, "Red");
      try {
        page.open(board.lines().get(0).replaceFirst("web: ", ""));

        awaitText("tiles", name + " (Red)");
        page.await("document.querySelector('.tile img').naturalWidth === 480");
        awaitText("ranking", "0 / 4");
        page.click("[data-do=pause][data-on=true]");
        page.click("#projector");
        page.await(
            "getComputedStyle(document.querySelector('[data-do=reset]')).display === 'none'");
        while (!simulator.current().simulation().snapshot().clock().paused()) {
          Thread.onSpinWait();
        }
        assertThat(page.value("document.title")).isEqualTo("The class");
      } finally {
        reporter.close();
      }
    }
  }
}
