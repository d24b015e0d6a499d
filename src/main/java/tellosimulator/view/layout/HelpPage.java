package tellosimulator.view.layout;

import atlantafx.base.theme.Styles;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Stream;
import javafx.beans.property.SimpleStringProperty;
import javafx.beans.property.StringProperty;
import javafx.beans.value.ObservableValue;
import javafx.geometry.VPos;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.control.Tab;
import javafx.scene.control.TabPane;
import javafx.scene.layout.GridPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.VBox;
import tellosimulator.view.controls.FirstProgram;
import tellosimulator.view.controls.NetworkControls;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.pilot.SteeringKey;
import tellosimulator.view.text.Messages;

/**
 * The page with the first steps, a first program, and the actions of mouse and keys. Confined to
 * the JavaFX thread.
 */
final class HelpPage extends Page {

  private static final List<String> STEPS = List.of("step-1", "step-2", "step-3", "step-4");

  static final List<String> MOUSE =
      List.of("mouse-turn", "mouse-shift", "mouse-zoom", "mouse-fine", "mouse-strong");

  static final List<String> PLAN =
      List.of("plan-drag", "plan-turn", "plan-nudge", "plan-delete", "plan-undo");

  private final ViewContext context;
  private final Messages messages;
  private final Messages steering;
  private final Messages panels;
  private final StringProperty address = new SimpleStringProperty("");
  private final FirstProgram program;
  private final TabPane tabs = new TabPane();

  HelpPage(ViewContext context) {
    super("help-page", context.language().messages(HelpPage.class).text("help"));
    this.context = context;
    messages = context.language().messages(HelpPage.class);
    steering = context.language().messages(SteeringKey.class);
    panels = context.language().messages(NetworkControls.class);
    program = new FirstProgram("help", context.language());
    setMaxHeight(USE_PREF_SIZE);
    tabs.setTabClosingPolicy(TabPane.TabClosingPolicy.UNAVAILABLE);
    addButton("help-close", messages.text("close"));
    layoutParts();
  }

  /** Updates the address of the selected drone. */
  void refresh() {
    int drone = context.simulation().selected().number();
    address.set(program.fly(context.actions().addresses(drone)));
  }

  private void layoutParts() {
    List<WindowKey> keys = Stream.of(WindowKey.values()).filter(key -> !key.looks()).toList();
    int half = (keys.size() + 1) / 2;
    Node steeringKeys =
        table("steering-keys", Stream.of(SteeringKey.values()).map(this::steeringRow));
    Node views =
        table(
            "view-keys", Stream.of(WindowKey.values()).filter(WindowKey::looks).map(this::keyRow));
    addTab("start", steps(), table("mouse", MOUSE.stream().map(this::mouseRow)));
    addTab("flying", new VBox(steeringKeys, wrapped("steering-note")), views);
    addTab(
        "window",
        table("window-keys", keys.subList(0, half).stream().map(this::keyRow)),
        table("more-keys", keys.subList(half, keys.size()).stream().map(this::keyRow)));
    addTab("plan", table("plan", PLAN.stream().map(this::mouseRow)));
    layoutPage(tabs);
  }

  /** Adds a tab with columns side by side. */
  private void addTab(String key, Node... columns) {
    HBox content = Nodes.styled(new HBox(columns), "columns");
    for (Node column : columns) {
      column.getStyleClass().add("column");
    }
    Tab tab = new Tab();
    tab.setId("help-tab-" + key);
    tab.textProperty().bind(messages.text("tab-" + key));
    tab.setContent(content);
    tabs.getTabs().add(tab);
  }

  private Node steps() {
    VBox all = Nodes.styled(new VBox(heading("first-steps")), "steps");
    STEPS.forEach(step -> all.getChildren().add(wrapped(step)));
    Label next = heading("first-program");
    next.getStyleClass().add("next");
    all.getChildren().addAll(next, program);
    return all;
  }

  /** A row of a table: the name of a key or mouse button, and its action. */
  private record Row(String id, ObservableValue<String> key, ObservableValue<String> meaning) {}

  private Row mouseRow(String key) {
    return new Row(key, messages.text(key), messages.text(key + "-does"));
  }

  private Row keyRow(WindowKey key) {
    ObservableValue<String> symbols = following(key::symbols);
    return new Row(key.textKey(), symbols, messages.text(key.textKey()));
  }

  private Row steeringRow(SteeringKey key) {
    ObservableValue<String> symbols =
        switch (key) {
          case FASTER -> messages.text("shift");
          case TAKE_OFF_OR_LAND -> messages.text("space");
          default -> following(any -> key.symbol());
        };
    return new Row("steering-" + key.textKey(), symbols, steering.text(key.textKey()));
  }

  private ObservableValue<String> following(Function<Messages, String> text) {
    return context.language().localeProperty().map(locale -> text.apply(messages));
  }

  private Node table(String headingKey, Stream<Row> rows) {
    GridPane table = Nodes.styled(new GridPane(), "key-table");
    rows.forEach(row -> addRow(table, row));
    return new VBox(heading(headingKey), table);
  }

  private static void addRow(GridPane table, Row row) {
    Label key = Nodes.unshrinkable(Nodes.label(row.key(), "key-name"));
    key.setId("help-" + row.id());
    GridPane.setValignment(key, VPos.TOP);
    table.addRow(table.getRowCount(), key, Nodes.wrapping(Nodes.label(row.meaning())));
  }

  private Label heading(String key) {
    return messages.label(key, Styles.TEXT_BOLD, "heading");
  }

  /**
   * Returns a label with wrapped text. The address and the labels of buttons are inserted into the
   * text.
   */
  private Label wrapped(String key) {
    Label text =
        Nodes.label(
            messages.text(
                key,
                address,
                panels.text("power.start"),
                steering.text("demo-IDLE"),
                steering.text("keyboard-flight")));
    return Nodes.wrapping(Nodes.named(text, "help-" + key));
  }
}
