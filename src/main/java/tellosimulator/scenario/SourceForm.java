package tellosimulator.scenario;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import tellosimulator.scenario.ScenarioCodec.ParsedScenario;
import tellosimulator.world.Obstacle;
import tellosimulator.world.Shape;

/**
 * The form in which an obstacle is written in a file, since several forms are possible. Immutable.
 *
 * @param named whether the file contains a name for the obstacle; otherwise, a name such as {@code
 *     box 1} is generated
 */
record SourceForm(Kind kind, boolean named) {

  /**
   * The kinds of obstacles in a file. In the simulation, a wall is a box, and a gate is a ring or a
   * frame.
   */
  enum Kind {
    BOX,
    CYLINDER,
    WALL,
    GATE;

    /** Returns the default kind of a shape. */
    private static Kind of(Shape shape) {
      return shape.match(
          new Shape.Cases<>(box -> BOX, cylinder -> CYLINDER, ring -> GATE, frame -> GATE));
    }

    /** Returns the key of obstacles of this kind. */
    String word() {
      return name().toLowerCase(Locale.ROOT);
    }
  }

  /** Returns the default form of an obstacle that is not in a file yet. */
  static SourceForm usual(Obstacle obstacle) {
    return new SourceForm(Kind.of(obstacle.shape()), true);
  }

  /** Returns whether an obstacle can be written in this form. */
  private boolean fits(Obstacle obstacle) {
    Kind usual = Kind.of(obstacle.shape());
    return kind == usual || (kind == Kind.WALL && usual == Kind.BOX);
  }

  /**
   * Returns the forms of the obstacles of a changed scenario. Existing obstacles keep their forms,
   * except that the file contains names for the renamed ones. New obstacles have the default form.
   *
   * @param matches for each obstacle, its previous index or {@link SourceLayout#NEW}
   * @param gatesNamed whether to name all gates in the file, because generated names would change
   */
  static List<SourceForm> kept(
      ParsedScenario before, List<Integer> matches, Scenario now, boolean gatesNamed) {
    List<Obstacle> old = before.scenario().config().arena().obstacles();
    List<SourceForm> forms = new ArrayList<>();
    for (Obstacle obstacle : now.config().arena().obstacles()) {
      int match = matches.get(forms.size());
      SourceForm form = usual(obstacle);
      if (match != SourceLayout.NEW && before.notations().get(match).fits(obstacle)) {
        SourceForm former = before.notations().get(match);
        boolean renamed = !old.get(match).name().equals(obstacle.name());
        boolean needsName = renamed || (gatesNamed && former.kind() == Kind.GATE);
        form = new SourceForm(former.kind(), former.named() || needsName);
      }
      forms.add(form);
    }
    return forms;
  }
}
