package tellosimulator.view.plan;

import java.util.List;
import java.util.function.Function;
import javafx.scene.paint.Color;
import tellosimulator.view.controls.NumberRange;

/**
 * An editable property of an item, for the property panel. Immutable.
 *
 * @param <V> the type of the value
 */
sealed interface ItemProperty<V> {

  /** Returns the suffix of the control's id. */
  String key();

  V value();

  /** Returns the function that creates the plan with another value. */
  Function<V, PlanChange> with();

  /** A number in the unit that scenario files use, rounded to tenths. */
  record Measure(String key, NumberRange range, Double value, Function<Double, PlanChange> with)
      implements ItemProperty<Double> {}

  /** One of several values. */
  record Choice<V>(String key, List<V> options, V value, Function<V, PlanChange> with)
      implements ItemProperty<V> {}

  /** The name of an obstacle. */
  record Name(String key, String value, Function<String, PlanChange> with)
      implements ItemProperty<String> {}

  /** The colour of an obstacle or a drone. */
  record Paint(String key, Color value, Function<Color, PlanChange> with)
      implements ItemProperty<Color> {}
}
