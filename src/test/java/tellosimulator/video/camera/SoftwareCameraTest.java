package tellosimulator.video.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;
import static tellosimulator.video.camera.TestScenes.BLACK;
import static tellosimulator.video.camera.TestScenes.BLUE;
import static tellosimulator.video.camera.TestScenes.GREEN;
import static tellosimulator.video.camera.TestScenes.RED;
import static tellosimulator.video.camera.TestScenes.WHITE;
import static tellosimulator.video.camera.TestScenes.painted;
import static tellosimulator.video.camera.TestScenes.plain;

import org.junit.jupiter.api.Test;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.mesh.Shading;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.video.camera.TestScenes.Quad;

class SoftwareCameraTest {

  private static final Vec3 MIDDLE = Vec3.ZERO;

  /** A square of 20 cm at a distance of 1 m is 10 pixels wide: 50 pixels a metre. */
  private static final double SIZE = 0.2;

  @Test
  void whatIsOnTheLeftAppearsOnTheLeft() {
    RenderedFrame frame =
        RenderedFrame.of(
            painted(plain(RED), Quad.ahead(1, new Vec3(0, 0.5, 0), SIZE)),
            painted(plain(GREEN), Quad.ahead(1, new Vec3(0, 0, 0.5), SIZE)));

    assertThat(frame.column(RED)).isCloseTo(50 - 0.5 * 50, within(0.01));
    assertThat(frame.row(RED)).isCloseTo(50, within(0.01));
    assertThat(frame.column(GREEN)).isCloseTo(50, within(0.01));
    assertThat(frame.row(GREEN)).as("up").isCloseTo(50 - 0.5 * 50, within(0.01));
    assertThat(frame.count(RED)).isEqualTo(10 * 10);
  }

  @Test
  void turningRightMovesTheImageToTheLeft() {
    Instance ahead = painted(plain(RED), Quad.ahead(1, MIDDLE, SIZE));

    RenderedFrame before = RenderedFrame.of(ahead);
    RenderedFrame after = RenderedFrame.of(Attitude.ofHeading(Math.toRadians(-10)), ahead);

    // 50 pixels times tan 10 degrees = 8.8
    assertThat(after.column(RED) - before.column(RED)).isCloseTo(-8.8, within(0.3));
  }

  @Test
  void theDepthTestKeepsTheNearestInAnyDrawingOrder() {
    Instance near = painted(plain(RED), Quad.ahead(1, MIDDLE, 0.4));
    Instance far = painted(plain(GREEN), Quad.ahead(2, MIDDLE, 4));

    for (RenderedFrame frame :
        new RenderedFrame[] {RenderedFrame.of(near, far), RenderedFrame.of(far, near)}) {
      assertThat(frame.count(RED)).isEqualTo(20 * 20);
      assertThat(frame.count(GREEN)).isEqualTo(100 * 100 - 20 * 20);
    }
  }

  @Test
  void intersectingQuadsAreDepthTestedPixelByPixel() {
    // From 1.5 m on the left to 0.5 m on the right, intersecting the other one in the middle.
    Instance slanted =
        painted(plain(RED), new Quad(new Vec3(1.5, 3, -3), new Vec3(-1, -6, 0), new Vec3(0, 0, 6)));
    Instance upright = painted(plain(GREEN), Quad.ahead(1, MIDDLE, 6));

    RenderedFrame frame = RenderedFrame.of(slanted, upright);

    assertThat(frame.rgb(25, 50)).isEqualTo(GREEN & 0xffffff);
    assertThat(frame.rgb(75, 50)).isEqualTo(RED & 0xffffff);
    assertThat(frame.count(RED)).isEqualTo(5000);
    assertThat(frame.count(GREEN)).isEqualTo(5000);
  }

  @Test
  void backFacesAreCulled() {
    Quad back = new Quad(new Vec3(1, -0.5, -0.5), new Vec3(0, 1, 0), new Vec3(0, 0, 1));

    assertThat(RenderedFrame.of(painted(plain(RED), back)).count(BLACK)).isEqualTo(100 * 100);
  }

  @Test
  void whatIsBehindTheCameraIsCulled() {
    Quad behind = Quad.ahead(-1, MIDDLE, 1);
    Quad behindTurned = new Quad(new Vec3(-1, -0.5, -0.5), new Vec3(0, 1, 0), new Vec3(0, 0, 1));

    RenderedFrame frame = RenderedFrame.of(painted(plain(RED), behind, behindTurned));

    assertThat(frame.count(BLACK)).isEqualTo(100 * 100);
  }

  @Test
  void aQuadThroughTheNearPlaneIsClipped() {
    // A floor 1 m below the eye, 10 m ahead and 10 m behind.
    Instance floor =
        painted(
            TestScenes.checkerboard(2, 64),
            new Quad(new Vec3(-10, 50, -1), new Vec3(0, -100, 0), new Vec3(20, 0, 0), 100, 20));

    RenderedFrame frame = RenderedFrame.of(floor);

    // Its far edge is 10 m away: 50 / 10 = 5 pixels below the middle.
    assertThat(frame.count(BLACK)).isEqualTo(55 * 100);
    assertThat(frame.rgb(50, 54)).isEqualTo(0);
    assertThat(frame.rgb(50, 55)).isNotEqualTo(0);
    assertThat(frame.rgb(0, 99)).isNotEqualTo(0);
    assertThat(frame.rgb(99, 99)).isNotEqualTo(0);
  }

  @Test
  void texturesAreUprightAndNotMirrored() {
    // Red and green above, blue and white below.
    Texture four = new Texture(2, 2, new int[] {RED, GREEN, BLUE, WHITE});

    RenderedFrame frame = RenderedFrame.of(painted(four, Quad.ahead(1, MIDDLE, 2)));

    // Half a pixel beside the centres of the texture's pixels, 50 pixels apart: 1 % of a neighbour.
    assertThat(channels(frame.rgb(25, 25))).containsExactly(channels(RED), within(8.0));
    assertThat(channels(frame.rgb(75, 25))).containsExactly(channels(GREEN), within(8.0));
    assertThat(channels(frame.rgb(25, 75))).containsExactly(channels(BLUE), within(8.0));
    assertThat(channels(frame.rgb(75, 75))).containsExactly(channels(WHITE), within(8.0));
  }

  @Test
  void aPartIsScaledAroundItsOrigin() {
    Part square = painted(plain(RED), Quad.ahead(0, MIDDLE, SIZE)).part();
    Pose ahead = new Pose(new Vec3(1, 0, 0), Attitude.LEVEL);

    assertThat(RenderedFrame.of(new Instance(square, ahead, 1, 1)).count(RED)).isEqualTo(10 * 10);
    assertThat(RenderedFrame.of(new Instance(square, ahead, 3, 1)).count(RED)).isEqualTo(30 * 30);
  }

  @Test
  void aPartIsDrawnAtItsPose() {
    Part square = painted(plain(RED), Quad.ahead(1, MIDDLE, SIZE)).part();
    // Turned left by 90 degrees, its front is towards y; from there it is moved in front of the
    // eye.
    Pose turned = new Pose(new Vec3(0.5, -1, 0.2), Attitude.ofHeading(Math.PI / 2));
    Attitude alongY = Attitude.ofHeading(Math.PI / 2);

    RenderedFrame frame =
        RenderedFrame.of(
            new PinholeCamera(new Pose(new Vec3(0, -1, 0), alongY), RenderedFrame.INTRINSICS, 0.1),
            new Instance(square, turned));

    // 1 m ahead (y), 0.5 m to the right (x), 0.2 m up
    assertThat(frame.column(RED)).isCloseTo(50 + 25, within(0.01));
    assertThat(frame.row(RED)).isCloseTo(50 - 10, within(0.01));
  }

  @Test
  void aDecalCoversCoplanarSurfacesButNotWhatStandsOnThem() {
    Quad floor = new Quad(new Vec3(0, 5, -1), new Vec3(0, -10, 0), new Vec3(10, 0, 0));
    Quad region = new Quad(new Vec3(1, 0.5, -1), new Vec3(0, -1, 0), new Vec3(4, 0, 0));
    Quad post = new Quad(new Vec3(2, 0.25, -1), new Vec3(0, -0.5, 0), new Vec3(0, 0, 0.5));
    Instance decal = new Instance(decal(RED, region), TestScenes.ORIGIN);

    RenderedFrame frame =
        RenderedFrame.of(painted(plain(GREEN), floor), decal, painted(plain(BLUE), post));

    RenderedFrame alone = RenderedFrame.of(decal);
    RenderedFrame postAlone = RenderedFrame.of(painted(plain(BLUE), post));
    assertThat(frame.count(BLUE)).isEqualTo(postAlone.count(BLUE)).isPositive();
    RenderedFrame both = RenderedFrame.of(decal, painted(plain(BLUE), post));
    assertThat(alone.count(RED)).isGreaterThan(both.count(RED));
    assertThat(frame.count(RED)).isEqualTo(both.count(RED));
  }

  @Test
  void aTranslucentDecalIsBlended() {
    Quad quad = Quad.ahead(1, MIDDLE, 2);
    Instance below = painted(plain(GREEN), quad);

    RenderedFrame half =
        RenderedFrame.of(below, new Instance(decal(RED, quad), TestScenes.ORIGIN, 1, 0.5));
    RenderedFrame none =
        RenderedFrame.of(below, new Instance(decal(RED, quad), TestScenes.ORIGIN, 1, 0));
    RenderedFrame quarter =
        RenderedFrame.of(below, new Instance(decal(0x80ff0000, quad), TestScenes.ORIGIN, 1, 0.5));

    assertThat(channels(half.rgb(50, 50))).containsExactly(new double[] {127, 127, 0}, within(2.0));
    assertThat(none.count(GREEN)).isEqualTo(100 * 100);
    assertThat(channels(quarter.rgb(50, 50)))
        .containsExactly(new double[] {64, 191, 0}, within(2.0));
  }

  @Test
  void sheerSurfacesAreDepthTestedButDoNotWriteDepth() {
    Quad quad = Quad.ahead(1, MIDDLE, 2);
    Instance sheer =
        new Instance(
            new Part(TestScenes.mesh(quad), plain(0x80ff0000), Shading.TRANSLUCENT),
            TestScenes.ORIGIN);

    RenderedFrame behind = RenderedFrame.of(sheer, painted(plain(GREEN), Quad.ahead(2, MIDDLE, 4)));
    RenderedFrame inFront =
        RenderedFrame.of(sheer, painted(plain(GREEN), Quad.ahead(0.5, MIDDLE, 1)));

    assertThat(channels(behind.rgb(50, 50)))
        .containsExactly(new double[] {128, 127, 0}, within(2.0));
    assertThat(inFront.count(GREEN)).isEqualTo(100 * 100);
  }

  @Test
  void aFrameBufferOfAnotherSizeThanTheImageIsRefused() {
    SoftwareCamera renderer = new SoftwareCamera(new RenderCache(ColorSpace.RGB));
    PinholeCamera camera = new PinholeCamera(TestScenes.ORIGIN, RenderedFrame.INTRINSICS, 0.1);

    assertThatIllegalArgumentException()
        .isThrownBy(() -> renderer.draw(TestScenes.scene(), camera, FrameBuffer.forScreen(100, 98)))
        .withMessageContaining("100 by 98");
  }

  private static Part decal(int argb, Quad quad) {
    return new Part(TestScenes.mesh(quad), plain(argb), Shading.DECAL);
  }

  private static double[] channels(int rgb) {
    return new double[] {(rgb >> 16) & 255, (rgb >> 8) & 255, rgb & 255};
  }
}
