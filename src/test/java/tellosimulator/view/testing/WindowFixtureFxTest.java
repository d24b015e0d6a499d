package tellosimulator.view.testing;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.atomic.AtomicLong;
import javafx.beans.binding.Bindings;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.layout.VBox;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import tellosimulator.model.FlightPhase;
import tellosimulator.view.model.ViewContext;

class WindowFixtureFxTest {

  private final AtomicLong beats = new AtomicLong();

  @RegisterExtension final WindowFixture window = new WindowFixture(this::build);

  @Test
  void whatIsClickedReachesTheCoreAndComesBackWithAPulse() {
    assertThat(window.find("power", Label.class).getText()).isEqualTo("off");

    window.robot().clickOn("#switch-on");

    WindowFixture.waitUntil(
        () -> window.simulation().snapshot().drones().get(0).state().phase() != FlightPhase.OFF);
    WindowFixture.waitUntil(() -> window.find("power", Label.class).getText().equals("on"));
  }

  @Test
  void theToolkitBeatsByItself() {
    WindowFixture.waitUntil(() -> beats.get() > 5);
  }

  private VBox build(ViewContext context) {
    context.ticker().onTick(nanos -> beats.incrementAndGet());
    Button button = new Button("On");
    button.setId("switch-on");
    button.setOnAction(
        event ->
            context
                .actions()
                .switchPower(1, true, refusal -> assertThat(refusal).as("why not").isEmpty()));
    Label label = new Label();
    label.setId("power");
    label
        .textProperty()
        .bind(
            Bindings.when(context.simulation().selected().onProperty())
                .then("on")
                .otherwise("off"));
    return new VBox(button, label);
  }
}
