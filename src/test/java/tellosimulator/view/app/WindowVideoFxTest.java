package tellosimulator.view.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.fail;
import static tellosimulator.view.testing.WindowFixture.onFxThread;
import static tellosimulator.view.testing.WindowFixture.waitUntil;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import javafx.scene.image.Image;
import javafx.scene.image.ImageView;
import javafx.scene.input.KeyCode;
import javax.imageio.ImageIO;
import org.jcodec.common.io.FileChannelWrapper;
import org.jcodec.common.io.NIOUtils;
import org.jcodec.containers.mp4.demuxer.MP4Demuxer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.testfx.api.FxRobot;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimConfig.Product;
import tellosimulator.sim.SimConfig.StreamPorts;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.testing.QuickRobot;
import tellosimulator.view.video.VideoCapture;
import tellosimulator.world.Room;

/** The window displays and saves the drones' video. */
class WindowVideoFxTest {

  /** The starts of two drones that face opposite walls. */
  private static final List<Pose> STARTS =
      List.of(
          new Pose(Vec3.ZERO, Attitude.LEVEL),
          new Pose(new Vec3(0, 1, 0), Attitude.ofHeading(Math.PI)));

  private final FxRobot robot = new QuickRobot();
  @TempDir private Path folder;
  private WholeWindow window;

  @BeforeEach
  void open() {
    SimConfig config = SimConfig.DEFAULT.withRoom(Room.DEFAULT, STARTS);
    window = WholeWindow.open(config, folder.resolve("settings"));
  }

  @AfterEach
  void close() {
    window.close();
  }

  @Test
  void theInsetShowsAPictureThoughNobodyTakesTheVideo() {
    robot.type(KeyCode.F6);

    waitUntil(() -> picture() != null);
    assertThat(window.shows("inset-live")).isFalse();
    robot.type(KeyCode.F6);
    assertThat(onFxThread(this::picture)).isNull();
  }

  @Test
  void whileTheVideoIsSentTheInsetSaysSo() {
    window.switchOn();
    robot.type(KeyCode.F6);

    window.fly("command", "streamon");
    waitUntil(() -> window.shows("inset-live"));

    window.fly("streamoff");
    waitUntil(() -> !window.shows("inset-live"));
  }

  @Test
  void theInsetFollowsTheSelection() {
    robot.type(KeyCode.F6);
    waitUntil(() -> picture() != null);
    int first = onFxThread(() -> checksum(picture()));

    window.change(
        () -> {
          FxSimulation simulation = window.context().simulation();
          simulation.selectedProperty().set(simulation.drones().get(1));
        });

    waitUntil(() -> picture() != null);
    assertThat(onFxThread(() -> checksum(picture()))).isNotEqualTo(first);
  }

  @Test
  void aKeySavesTheNextPictureAndTheLogNamesTheFile() throws IOException {
    robot.type(KeyCode.F8);

    waitUntil(() -> window.log().stream().anyMatch(line -> line.contains("was saved")));
    Path file = kept(".png");
    assertThat(window.log()).anyMatch(line -> line.endsWith("a picture was saved: " + file));
    BufferedImage still = ImageIO.read(file.toFile());
    assertThat(still.getWidth()).isEqualTo(960);
    assertThat(still.getHeight()).isEqualTo(720);
    assertThat(still.getRGB(480, 10)).isNotEqualTo(still.getRGB(480, 715));
  }

  @Test
  void twoPicturesAtOnceAreTwoFiles() throws IOException {
    window.change(
        () -> {
          VideoCapture capture = window.context().video().capture(1);
          capture.saveStill();
          capture.saveStill();
        });

    waitUntil(
        () -> window.log().stream().filter(line -> line.contains("was saved: ")).count() == 2);
    try (Stream<Path> files = Files.list(folder.resolve("Tello Simulator"))) {
      assertThat(files).hasSize(2);
    }
  }

  @Test
  void aPictureThatCannotBeSavedIsExplained() throws IOException {
    Path inTheWay = Files.createFile(folder.resolve("Tello Simulator"));

    robot.type(KeyCode.F8);

    String why = "a picture could not be saved: " + inTheWay + " is in the way";
    waitUntil(() -> window.log().stream().anyMatch(line -> line.endsWith(why)));
  }

  @Test
  void theButtonRecordsUntilItIsPressedAgain() throws IOException {
    window.switchOn();
    robot.type(KeyCode.F6);
    robot.clickOn("#inset-record");
    waitUntil(() -> window.text("inset-record").matches("0:0[1-9]"));
    awaitSomePictures();
    robot.type(KeyCode.F6);
    assertThat(window.shows("inset-record")).as("even if the inset is hidden").isTrue();

    robot.clickOn("#inset-record");

    assertThat(window.text("inset-record")).isEmpty();
    assertThat(window.shows("inset-record")).isFalse();
    assertThat(pictures()).isPositive();
    waitUntil(() -> window.log().stream().anyMatch(line -> line.contains("was recorded, ")));
  }

  @Test
  void aRecordingEndsWhenTheDroneIsSwitchedOff() throws IOException {
    robot.type(KeyCode.F12);
    waitUntil(() -> window.log().stream().anyMatch(line -> line.contains("nothing to record")));
    window.switchOn();
    robot.type(KeyCode.F12);
    awaitSomePictures();

    window.change(() -> window.context().actions().switchPower(1, false));

    waitUntil(() -> !window.shows("inset-record"));
    assertThat(pictures()).isPositive();
  }

  @Test
  void aRecordingEndsWhenItsPicturesHaveAnotherSize() throws IOException {
    window.carryOut(
        new Control.Configure(1, new Product(Profile.TT, Behavior.REPORT), new StreamPorts(9, 9)));
    window.switchOn();
    robot.type(KeyCode.F12);
    awaitSomePictures();

    window.fly("command", "setresolution low");

    waitUntil(() -> window.log().stream().anyMatch(line -> line.contains("another size")));
    assertThat(window.shows("inset-record")).isFalse();
    assertThat(pictures()).isPositive();
  }

  @Test
  void aRecordingEndsWithTheWindow() throws IOException {
    window.switchOn();
    robot.type(KeyCode.F12);
    awaitSomePictures();

    window.close();

    assertThat(pictures()).isPositive();
  }

  private void awaitSomePictures() {
    waitUntil(() -> window.log().stream().anyMatch(line -> line.contains("is being recorded")));
    waitUntil(() -> Files.size(kept(".mp4")) > 10_000);
  }

  /** Returns the only file with this extension. */
  private Path kept(String ending) throws IOException {
    try (Stream<Path> files = Files.list(folder.resolve("Tello Simulator"))) {
      return files
          .filter(file -> file.toString().endsWith(ending))
          .reduce((one, other) -> fail("there are %s and %s", one, other))
          .orElseThrow();
    }
  }

  /** Returns the number of pictures in the recorded video. */
  private int pictures() throws IOException {
    try (FileChannelWrapper channel = NIOUtils.readableChannel(kept(".mp4").toFile())) {
      return MP4Demuxer.createMP4Demuxer(channel).getVideoTrack().getMeta().getTotalFrames();
    }
  }

  private Image picture() {
    return window.find("inset-picture", ImageView.class).getImage();
  }

  private static int checksum(Image image) {
    int sum = 0;
    for (int x = 0; x < (int) image.getWidth(); x++) {
      for (int y = 0; y < (int) image.getHeight(); y++) {
        sum = sum * 31 + image.getPixelReader().getArgb(x, y);
      }
    }
    return sum;
  }
}
