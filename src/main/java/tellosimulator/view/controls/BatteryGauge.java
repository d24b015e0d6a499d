package tellosimulator.view.controls;

import javafx.beans.property.DoubleProperty;
import javafx.beans.property.SimpleDoubleProperty;
import javafx.css.PseudoClass;
import javafx.scene.shape.Rectangle;
import javafx.scene.text.Text;
import tellosimulator.model.Battery;
import tellosimulator.view.text.Messages;

/** The battery's charge as a filled battery and a number. For the JavaFX thread. */
final class BatteryGauge extends Instrument {

  /** What the charge means for flying, by the drone's own limits. */
  enum Charge {
    /** Flips are possible. */
    GOOD(Battery.LEAST_FOR_FLIP),
    /** No flips. */
    FAIR(2 * Battery.TOO_LOW_FOR_TAKEOFF),
    /** Soon no takeoff any more. */
    LOW(Battery.TOO_LOW_FOR_TAKEOFF + 1),
    /** No takeoff, and before long it lands by itself. */
    CRITICAL(0);

    private final int least;

    Charge(int least) {
      this.least = least;
    }

    static Charge of(double percent) {
      for (Charge charge : values()) {
        if (percent >= charge.least) {
          return charge;
        }
      }
      return CRITICAL;
    }
  }

  private static final PseudoClass FAIR = PseudoClass.getPseudoClass("fair");
  private static final PseudoClass LOW = PseudoClass.getPseudoClass("low");
  private static final PseudoClass CRITICAL = PseudoClass.getPseudoClass("critical");

  /** Size of the battery, and of everything [px]. */
  private static final double CASE_WIDTH = 30;

  private static final double HEIGHT = 16;
  private static final double WIDTH = 79;

  /** What is between the case and its filling [px]. */
  private static final double GAP = 2.5;

  private final DoubleProperty percent = new SimpleDoubleProperty(this, "percent", -1);
  private final Messages messages;
  private final Rectangle filling = new Rectangle();
  private final Text number = new Text();
  private double drawn = Double.NaN;

  BatteryGauge(Messages messages) {
    super("battery", "battery-gauge", WIDTH, HEIGHT);
    this.messages = messages;
    initializeParts();
    layoutParts();
    setupBindings();
  }

  private void initializeParts() {
    filling.setX(GAP);
    filling.setY(GAP);
    filling.setHeight(HEIGHT - 2 * GAP);
    filling.setArcWidth(3);
    filling.setArcHeight(3);
    filling.getStyleClass().add("filling");
    filling.setManaged(false);
    number.setId("battery-percent");
    number.getStyleClass().add("number");
  }

  private void layoutParts() {
    Rectangle body = new Rectangle(0.5, 0.5, CASE_WIDTH - 1, HEIGHT - 1);
    body.setArcWidth(6);
    body.setArcHeight(6);
    body.getStyleClass().add("case");
    Rectangle pole = new Rectangle(CASE_WIDTH, HEIGHT / 2 - 3, 2.5, 6);
    pole.getStyleClass().add("pole");
    body.setManaged(false);
    pole.setManaged(false);
    getChildren()
        .addAll(body, pole, filling, CenteredText.rightAligned(number, WIDTH - 1, HEIGHT / 2));
  }

  private void setupBindings() {
    percent.addListener((property, before, now) -> draw());
  }

  /** 0 to 100. */
  DoubleProperty percentProperty() {
    return percent;
  }

  private void draw() {
    double whole = Math.rint(percent.get());
    if (whole == drawn) {
      return;
    }
    drawn = whole;
    filling.setWidth((CASE_WIDTH - 2 * GAP) * Math.max(0, Math.min(1, whole / 100)));
    number.setText(NumberText.whole(whole) + " %");
    Charge charge = Charge.of(whole);
    pseudoClassStateChanged(FAIR, charge == Charge.FAIR);
    pseudoClassStateChanged(LOW, charge == Charge.LOW);
    pseudoClassStateChanged(CRITICAL, charge == Charge.CRITICAL);
  }

  @Override
  String description() {
    return messages.now("battery.accessible", NumberText.whole(percent.get()));
  }
}
