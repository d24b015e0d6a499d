package tellosimulator.view.plan;

import static org.assertj.core.api.Assertions.assertThat;
import static org.mockito.Mockito.mock;
import static org.mockito.Mockito.withSettings;
import static tellosimulator.view.testing.WindowFixture.onFxThread;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalInt;
import java.util.concurrent.TimeoutException;
import java.util.stream.Stream;
import javafx.geometry.BoundingBox;
import javafx.geometry.Bounds;
import javafx.geometry.Point2D;
import javafx.scene.SnapshotParameters;
import javafx.scene.canvas.Canvas;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.image.Image;
import javafx.scene.paint.Color;
import javafx.scene.text.Text;
import javafx.scene.text.TextAlignment;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.mockito.invocation.InvocationOnMock;
import org.testfx.api.FxToolkit;
import tellosimulator.goal.PlacedGoal;
import tellosimulator.goal.Progress;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.scenario.Gallery;
import tellosimulator.scenario.Scenario;
import tellosimulator.scenery.drone.Livery;
import tellosimulator.testing.SimulatedDrones;
import tellosimulator.view.fx.FxTextures;
import tellosimulator.view.plan.PlanItem.ObstacleItem;
import tellosimulator.view.text.Language;
import tellosimulator.world.Arena;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleAppearance;
import tellosimulator.world.ObstacleAppearance.Pattern;
import tellosimulator.world.Shape;

/** Every text on the plans of the included scenarios is readable: none overlaps anything else. */
class PlanLabelsFxTest {

  /** The colour behind the plan in the dark theme, which is the less favourable one. */
  private static final Color DARK = Color.web("#010409");

  /** Minimum contrast of texts. Documented: WCAG 2.1, level AA. */
  private static final double READABLE = 4.5;

  @BeforeEach
  void startToolkit() throws TimeoutException {
    FxToolkit.registerPrimaryStage();
  }

  /** The plan's sizes in windows of 900 by 600 and of 1280 by 800 pixels. */
  private static Stream<Arguments> plans() {
    return Gallery.NAMES.stream()
        .flatMap(
            name ->
                Stream.of(Locale.ENGLISH, Locale.GERMAN)
                    .flatMap(
                        language ->
                            Stream.of(
                                Arguments.of(name, language, 358, 457),
                                Arguments.of(name, language, 738, 657))));
  }

  @ParameterizedTest
  @MethodSource("plans")
  void textsOverlapNothingAndHaveContrast(String name, Locale language, int width, int height) {
    Scenario scenario = Gallery.find(name).orElseThrow();
    FloorPlan plan =
        FloorPlans.of(scenario.config().arena(), scenario.config().starts())
            .withChallenge(scenario.challenge());
    List<Color> colors =
        new SimulatedDrones(scenario.config(), List.of())
            .snapshot().drones().stream()
                .map(drone -> FxTextures.color(Livery.of(drone).color()))
                .toList();
    PlanViewport scale = PlanViewport.whole(plan.arena().room(), width, height);
    Drawing drawing =
        onFxThread(() -> new Drawing(plan, scale, new Language(language), colors, List.of()));

    assertThat(drawing.texts).extracting(Written::text).contains("x", "y", "front");
    assertThat(drawing.overlaps()).isEmpty();
    assertThat(drawing.texts)
        .allSatisfy(text -> assertThat(drawing.contrast(text)).isGreaterThanOrEqualTo(READABLE));
  }

  @Test
  void labelsAreShortenedOrLeftOutThoseOfSelectedItemsLast() {
    Pose start = new Pose(new Vec3(-2, -2, 0), Attitude.LEVEL);
    FloorPlan plan = FloorPlans.of(Arena.DEFAULT, List.of(start));
    ObstacleAppearance cover = new ObstacleAppearance(0x202020, Pattern.PLAIN, Map.of());
    for (int i = 1; i <= 40; i++) {
      Shape box = new Shape.Box(1, 1, i / 10.0);
      plan = plan.with(new Obstacle("rather narrow obstacle " + i, box, Vec3.ZERO, 0, cover));
    }
    String last = "rather narrow obstacle 40 · h 400";

    Drawing none = crowded(plan, 57, List.of());
    Drawing selected = crowded(plan, 57, List.of(new ObstacleItem(39)));
    Drawing narrow = crowded(plan, 36, List.of()); // 180 pixels between the walls

    assertThat(none.overlaps()).isEmpty();
    assertThat(none.texts).extracting(Written::text).doesNotContain(last);
    assertThat(selected.overlaps()).isEmpty();
    assertThat(selected.texts).extracting(Written::text).contains(last);
    assertThat(narrow.texts).extracting(Written::text).contains("rather n…");
  }

  private static Drawing crowded(FloorPlan plan, double pixels, List<PlanItem> selected) {
    PlanViewport scale = new PlanViewport(Vec3.ZERO, pixels, 358, 457);
    return onFxThread(
        () ->
            new Drawing(plan, scale, new Language(Locale.ENGLISH), List.of(Color.BLUE), selected));
  }

  /** A text with its area on the screen. */
  private record Written(String text, Bounds area, Color color) {}

  private static final class Drawing {

    private final List<Written> texts = new ArrayList<>();
    private final List<Bounds> plates = new ArrayList<>();
    private final FloorPlan plan;
    private final PlanViewport scale;
    private final List<PlacedGoal> goals;
    private final Image picture;

    Drawing(
        FloorPlan plan,
        PlanViewport scale,
        Language language,
        List<Color> colors,
        List<PlanItem> selected) {
      this.plan = plan;
      this.scale = scale;
      goals = PlacedGoal.of(Progress.start(plan.challenge()), plan.arena());
      Canvas canvas = new Canvas(scale.width(), scale.height());
      GraphicsContext pen =
          mock(
              GraphicsContext.class,
              withSettings()
                  .spiedInstance(canvas.getGraphicsContext2D())
                  .defaultAnswer(this::observe));
      PlanPainter painter = new PlanPainter(pen, drone -> colors.get(drone - 1), language::say);
      OptionalInt chosen = colors.size() > 1 ? OptionalInt.of(1) : OptionalInt.empty();
      painter.paint(plan, scale, new PlanPainter.Remarks(goals, List.of(), chosen, "front"));
      painter.label(plan, selected);
      SnapshotParameters parameters = new SnapshotParameters();
      parameters.setFill(DARK);
      picture = canvas.snapshot(parameters, null);
    }

    private Object observe(InvocationOnMock call) throws Throwable {
      GraphicsContext pen = (GraphicsContext) call.getMock();
      if (call.getMethod().getName().equals("fillText")) {
        String text = call.getArgument(0);
        Text measured = new Text(text);
        measured.setFont(pen.getFont());
        double size = pen.getFont().getSize() * 0.8; // digits and capitals
        double width = measured.getLayoutBounds().getWidth();
        double x = call.getArgument(1);
        double y = call.getArgument(2);
        double left = pen.getTextAlign() == TextAlignment.CENTER ? x - width / 2 : x;
        Bounds area = new BoundingBox(left, y - size / 2, width, size);
        texts.add(new Written(text, pen.getTransform().transform(area), (Color) pen.getFill()));
      } else if (call.getMethod().getName().equals("fillRoundRect")) {
        double left = call.getArgument(0);
        double top = call.getArgument(1);
        plates.add(new BoundingBox(left, top, call.getArgument(2), call.getArgument(3)));
      }
      return call.callRealMethod();
    }

    /** Returns what overlaps, in words. */
    List<String> overlaps() {
      List<String> found = new ArrayList<>();
      for (Written text : texts) {
        texts.subList(0, texts.indexOf(text)).stream()
            .filter(other -> other.area.intersects(text.area))
            .forEach(other -> found.add(text.text + " over " + other.text));
        Bounds label =
            plates.stream()
                .filter(plate -> plate.contains(text.area))
                .findFirst()
                .orElse(text.area);
        symbols(label).forEach(symbol -> found.add(text.text + " over " + symbol));
      }
      return found;
    }

    /** Returns the symbols that a label overlaps, except for the one around its middle. */
    private List<String> symbols(Bounds label) {
      List<String> found = new ArrayList<>();
      Point2D middle = new Point2D(label.getCenterX(), label.getCenterY());
      for (int drone = 1; drone <= plan.drones().size(); drone++) {
        Point2D at = scale.screen(plan.starts().get(drone - 1).position());
        double radius = Math.max(9, DroneSpec.COLLIDER.radius() * scale.pixels());
        if (middle.distance(at) > 1 && nearest(label, at) < radius) {
          found.add("drone " + drone);
        }
      }
      for (MissionPad pad : plan.arena().pads()) {
        Point2D at = scale.screen(pad.pose(plan.arena().room()).position());
        double half = MissionPad.EDGE / 2 * scale.pixels();
        if (middle.distance(at) > half && !pad.surface().wall() && nearest(label, at) < half) {
          found.add("pad " + pad.id());
        }
      }
      for (PlacedGoal goal : goals) {
        Point2D at = scale.screen(goal.place().middle());
        double rim = radius(goal.place()) * scale.pixels();
        if (rim > 0 && nearest(label, at) < rim && farthest(label, at) > rim) {
          found.add("rim of goal " + goal.number());
        }
      }
      return found;
    }

    private static double radius(PlacedGoal.Place place) {
      if (place instanceof PlacedGoal.Ball ball) {
        return ball.radius();
      }
      return place instanceof PlacedGoal.Circle circle ? circle.radius() : 0;
    }

    private static double nearest(Bounds label, Point2D at) {
      return Math.hypot(
          Math.max(0, Math.abs(label.getCenterX() - at.getX()) - label.getWidth() / 2),
          Math.max(0, Math.abs(label.getCenterY() - at.getY()) - label.getHeight() / 2));
    }

    private static double farthest(Bounds label, Point2D at) {
      return Math.hypot(
          Math.abs(label.getCenterX() - at.getX()) + label.getWidth() / 2,
          Math.abs(label.getCenterY() - at.getY()) + label.getHeight() / 2);
    }

    /** Returns the lowest contrast between a text and the colours that are frequent under it. */
    double contrast(Written text) {
      Map<Color, Integer> counts = new HashMap<>();
      int pixels = 0;
      for (int x = (int) text.area.getMinX(); x < text.area.getMaxX(); x++) {
        for (int y = (int) text.area.getMinY(); y < text.area.getMaxY(); y++) {
          counts.merge(picture.getPixelReader().getColor(x, y), 1, Integer::sum);
          pixels++;
        }
      }
      double frequent = 0.15 * pixels; // edges of letters have many colours, each of them rare
      return counts.entrySet().stream()
          .filter(color -> color.getValue() > frequent && !color.getKey().equals(text.color))
          .mapToDouble(color -> contrast(color.getKey(), text.color))
          .min()
          .orElseThrow();
    }

    private static double contrast(Color one, Color other) {
      double first = luminance(one) + 0.05;
      double second = luminance(other) + 0.05;
      return Math.max(first, second) / Math.min(first, second);
    }

    private static double luminance(Color color) {
      return 0.2126 * Math.pow(color.getRed(), 2.2)
          + 0.7152 * Math.pow(color.getGreen(), 2.2)
          + 0.0722 * Math.pow(color.getBlue(), 2.2);
    }
  }
}
