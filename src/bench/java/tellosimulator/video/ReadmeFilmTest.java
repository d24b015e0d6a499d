package tellosimulator.video;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Polygon;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.goal.GoalWatch;
import tellosimulator.goal.PlacedGoal;
import tellosimulator.goal.Progress;
import tellosimulator.goal.Progress.Status;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenario.Gallery;
import tellosimulator.scenario.Scenario;
import tellosimulator.scenery.SceneBuilder;
import tellosimulator.scenery.overlay.Eye;
import tellosimulator.scenery.overlay.Overlay;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimListener;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.testing.CompressedImage;
import tellosimulator.testing.SimulatedDrones;
import tellosimulator.video.camera.CameraIntrinsics;
import tellosimulator.video.camera.ColorSpace;
import tellosimulator.video.camera.FrameBuffer;
import tellosimulator.video.camera.PinholeCamera;
import tellosimulator.video.camera.RenderCache;
import tellosimulator.video.camera.SoftwareCamera;
import tellosimulator.video.codec.AccessUnit;
import tellosimulator.video.codec.H264Encoder;
import tellosimulator.video.picture.Picture;

/**
 * Films the gate race for the README, flown by a list of commands and rendered by a camera that
 * moves around the room. With {@code -Dupdate.docs=true} it recreates the film and its picture:
 *
 * <pre>{@code mvn -Pbench test -Dtest=ReadmeFilmTest -Dupdate.docs=true}</pre>
 */
@Tag("bench")
class ReadmeFilmTest {

  private static final boolean UPDATE = Boolean.getBoolean("update.docs");
  private static final Path IMAGES = Path.of("docs", "images");

  private static final String[] RACE = {
    "command",
    "speed 100",
    "takeoff",
    "up 70",
    "forward 150",
    "up 50",
    "forward 200",
    "ccw 90",
    "down 30",
    "forward 200",
    "forward 50",
    "land"
  };

  private static final double SECONDS = 15;

  /** With few frames unless the film is written. */
  private static final int FRAMES_PER_SECOND = UPDATE ? 25 : 1;

  private static final int BITS_PER_SECOND = 950_000;

  /** Maximum size of the film [bytes]. Decided: acceptable for a page to load unasked. */
  private static final int LARGEST = 2_000_000;

  private static final int WIDTH = 768;
  private static final int HEIGHT = 432;

  /** Supersampling factor of each side, for smooth edges. */
  private static final int FINER = 2;

  private static final double FIELD_OF_VIEW = Math.toRadians(46);
  private static final double ELEVATION = Math.toRadians(27);
  private static final double NEAR = 0.05;

  /**
   * Factor of the camera's distance, above 1 so that the room's near corner is visible, too. By
   * eye.
   */
  private static final double ASIDE = 1.1;

  /** Headings of the camera at the start and the end of the film [rad]. */
  private static final double FIRST_HEADING = Math.toRadians(4);

  private static final double LAST_HEADING = Math.toRadians(46);

  /** Position of the picture for the README in the film. Decided: in the second gate. */
  private static final double OF_PICTURE = 0.62;

  private static final Color SKY = new Color(0xeaf1f8);
  private static final Color GROUND = new Color(0xb9c7d6);

  @TempDir private Path folder;

  private final SceneBuilder scenes = new SceneBuilder();
  private final SoftwareCamera camera = new SoftwareCamera(new RenderCache(ColorSpace.RGB));
  private final FrameBuffer frameBuffer = FrameBuffer.forScreen(FINER * WIDTH, FINER * HEIGHT);

  /** The state after a step. */
  private record Moment(SimSnapshot snapshot, Progress progress) {}

  /** Collects all moments from the takeoff on. */
  private static final class Moments implements SimListener {
    private final GoalWatch goals;
    private final List<Moment> all = new ArrayList<>();

    Moments(GoalWatch goals) {
      this.goals = goals;
    }

    @Override
    public void event(SimEvent event) {}

    @Override
    public void stepped(SimSnapshot snapshot) {
      if (!all.isEmpty() || snapshot.drones().get(0).state().phase().flying()) {
        all.add(new Moment(snapshot, goals.progress()));
      }
    }
  }

  @Test
  void theGateRace() throws IOException {
    List<Moment> flight = flight(Gallery.find("gate-race").orElseThrow());
    assertThat(flight.get(flight.size() - 1).progress().status()).isEqualTo(Status.REACHED);

    Path film = folder.resolve("film.mp4");
    BufferedImage picture = film(flight, film);

    assertThat(Files.size(film)).isBetween(10_000L, (long) LARGEST);
    byte[] jpeg = CompressedImage.bytes(withPlaySign(picture), "jpeg", 0.88f);
    assertThat(jpeg.length).isBetween(10_000, 200_000);
    if (UPDATE) {
      Files.createDirectories(IMAGES);
      Files.copy(film, IMAGES.resolve("film.mp4"), StandardCopyOption.REPLACE_EXISTING);
      Files.write(IMAGES.resolve("film.jpg"), jpeg);
    }
  }

  private static List<Moment> flight(Scenario scenario) {
    GoalWatch goals = new GoalWatch(scenario.challenge(), news -> {});
    Moments moments = new Moments(goals);
    SimulatedDrones drones = new SimulatedDrones(scenario.config(), List.of(goals, moments));
    drones.fly(RACE);
    drones.advance(1.5); // the last goal turns green
    return moments.all;
  }

  /**
   * Renders as many moments as the film has frames, evenly over the flight, and returns the picture
   * for the README.
   */
  private BufferedImage film(List<Moment> flight, Path file) throws IOException {
    int frames = (int) (SECONDS * FRAMES_PER_SECOND);
    int shown = (int) (OF_PICTURE * frames);
    H264Encoder encoder = new H264Encoder(WIDTH, HEIGHT);
    encoder.setRate(FRAMES_PER_SECOND, BITS_PER_SECOND);
    Overlay overlay = new Overlay(flight.get(0).snapshot());
    BufferedImage kept = null;
    Optional<Mp4File> film = Optional.empty();
    try (FileChannel channel = Mp4File.create(file)) {
      for (int i = 0; i < frames; i++) {
        double part = i / (frames - 1.0);
        Moment moment = flight.get((int) Math.round(part * (flight.size() - 1)));
        BufferedImage image = image(moment, overlay, part);
        kept = i == shown ? image : kept;
        AccessUnit encoded = encoder.encode(picture(image), i % (4 * FRAMES_PER_SECOND) == 0);
        if (film.isEmpty()) {
          film =
              Optional.of(
                  Mp4File.begin(
                      channel,
                      new Mp4File.Format(WIDTH, HEIGHT, unit(encoded, 0), unit(encoded, 1))));
        }
        film.get()
            .add(
                List.of(
                    new Mp4File.Sample(
                        unit(encoded, encoded.nalUnits() - 1),
                        encoded.idr(),
                        Mp4File.TIMESCALE / FRAMES_PER_SECOND)));
      }
      film.orElseThrow().close();
    }
    return kept;
  }

  /** Returns a NAL unit without its start code. */
  private static byte[] unit(AccessUnit encoded, int unit) {
    return Arrays.copyOfRange(encoded.bytes(), encoded.start(unit) + 4, encoded.start(unit + 1));
  }

  private BufferedImage image(Moment moment, Overlay overlay, double part) {
    SimSnapshot snapshot = moment.snapshot();
    PinholeCamera eye = camera(snapshot, FIRST_HEADING + part * (LAST_HEADING - FIRST_HEADING));
    overlay.advance(snapshot, snapshot.time().nanos());
    overlay.show(PlacedGoal.of(moment.progress(), snapshot.arena()), List.of());
    camera.draw(
        scenes.scene(snapshot).withOverlay(overlay.instances(snapshot, new Eye(eye.pose(), NEAR))),
        eye,
        frameBuffer);
    int[] argb = new int[FINER * WIDTH * FINER * HEIGHT];
    frameBuffer.copyTo(argb);
    return smooth(argb);
  }

  /**
   * Returns a camera that looks at the middle of the room, from a distance at which the room's
   * diagonal is visible.
   */
  private static PinholeCamera camera(SimSnapshot snapshot, double heading) {
    Attitude view =
        Attitude.ofHeading(heading)
            .after(new Attitude(Math.cos(ELEVATION / 2), 0, Math.sin(ELEVATION / 2), 0));
    double diagonal = Math.hypot(snapshot.room().depth(), snapshot.room().width());
    double distance = ASIDE * diagonal / 2 / Math.tan(FIELD_OF_VIEW / 2);
    Vec3 middle = new Vec3(-0.3, 0, 0.3 * snapshot.room().height());
    Vec3 eye = middle.minus(view.toRoom(new Vec3(distance, 0, 0)));
    return new PinholeCamera(
        new Pose(eye, view),
        new CameraIntrinsics(FINER * WIDTH, FINER * HEIGHT, FIELD_OF_VIEW),
        NEAR);
  }

  /** Averages the pixels that were rendered for each pixel, in front of a background. */
  private static BufferedImage smooth(int[] argb) {
    BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
    for (int y = 0; y < HEIGHT; y++) {
      Color behind = background(y);
      for (int x = 0; x < WIDTH; x++) {
        int red = 0;
        int green = 0;
        int blue = 0;
        for (int i = 0; i < FINER * FINER; i++) {
          int pixel = argb[(FINER * y + i / FINER) * FINER * WIDTH + FINER * x + i % FINER];
          Color color = pixel == 0 ? behind : new Color(pixel);
          red += color.getRed();
          green += color.getGreen();
          blue += color.getBlue();
        }
        int count = FINER * FINER;
        image.setRGB(x, y, new Color(red / count, green / count, blue / count).getRGB());
      }
    }
    return image;
  }

  private static Color background(int y) {
    float part = y / (float) HEIGHT;
    return new Color(
        Math.round(SKY.getRed() + part * (GROUND.getRed() - SKY.getRed())),
        Math.round(SKY.getGreen() + part * (GROUND.getGreen() - SKY.getGreen())),
        Math.round(SKY.getBlue() + part * (GROUND.getBlue() - SKY.getBlue())));
  }

  /** Converts to Y, Cb and Cr of ITU-R BT.601 at limited range. */
  private static Picture picture(BufferedImage image) {
    Picture picture = new Picture(WIDTH, HEIGHT);
    for (int y = 0; y < HEIGHT; y++) {
      for (int x = 0; x < WIDTH; x++) {
        Color color = new Color(image.getRGB(x, y));
        double red = color.getRed();
        double green = color.getGreen();
        double blue = color.getBlue();
        picture.y()[y * WIDTH + x] =
            (byte) Math.round(16 + 0.2568 * red + 0.5041 * green + 0.0979 * blue);
        if (x % 2 == 0 && y % 2 == 0) {
          int at = y / 2 * (WIDTH / 2) + x / 2;
          picture.u()[at] = (byte) Math.round(128 - 0.1482 * red - 0.291 * green + 0.4392 * blue);
          picture.v()[at] = (byte) Math.round(128 + 0.4392 * red - 0.3678 * green - 0.0714 * blue);
        }
      }
    }
    return picture;
  }

  private static BufferedImage withPlaySign(BufferedImage image) {
    Graphics2D pen = image.createGraphics();
    pen.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    pen.setColor(new Color(20, 30, 45, 150));
    pen.fillOval(WIDTH / 2 - 40, HEIGHT / 2 - 40, 80, 80);
    pen.setColor(Color.WHITE);
    pen.setStroke(new BasicStroke(3));
    pen.drawOval(WIDTH / 2 - 40, HEIGHT / 2 - 40, 80, 80);
    int[] x = {WIDTH / 2 - 12, WIDTH / 2 - 12, WIDTH / 2 + 22};
    int[] y = {HEIGHT / 2 - 20, HEIGHT / 2 + 20, HEIGHT / 2};
    pen.fill(new Polygon(x, y, 3));
    pen.dispose();
    return image;
  }
}
