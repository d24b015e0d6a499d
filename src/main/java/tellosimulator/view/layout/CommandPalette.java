package tellosimulator.view.layout;

import javafx.application.Platform;
import javafx.scene.control.Label;
import javafx.scene.control.ListCell;
import javafx.scene.control.ListView;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

/**
 * A field in which one types what the window shall do, and below it what fits; Enter or a click
 * does it. For the JavaFX thread.
 */
final class CommandPalette extends VBox {

  private static final double WIDTH = 560;

  /** Height of the list [px]. Decided: ten commands. */
  private static final double LIST_HEIGHT = 330;

  private final Messages messages;
  private final WindowCommands commands;
  private final Runnable close;
  private final TextField field = new TextField();
  private final ListView<WindowCommand> list = new ListView<>();

  /**
   * @param close hides it
   */
  CommandPalette(Language language, WindowCommands commands, Runnable close) {
    this.messages = language.messages(CommandPalette.class);
    this.commands = commands;
    this.close = close;
    initializeSelf();
    initializeParts();
    setupEventHandlers();
    search();
  }

  /** Where one types. */
  TextField field() {
    return field;
  }

  private void initializeSelf() {
    setId("command-palette");
    getStyleClass().addAll("page", "command-palette");
    getStylesheets().add(Page.class.getResource("pages.css").toExternalForm());
    setMaxSize(WIDTH, USE_PREF_SIZE);
  }

  private void initializeParts() {
    field.setId("command-search");
    field.promptTextProperty().bind(messages.text("commands-prompt"));
    field.accessibleTextProperty().bind(messages.text("key-commands"));
    field.accessibleHelpProperty().bind(messages.text("commands-prompt"));
    list.setId("command-list");
    list.setPrefHeight(LIST_HEIGHT);
    list.setFocusTraversable(false); // its keys are those of the field
    list.accessibleTextProperty().bind(messages.text("key-commands"));
    list.setCellFactory(view -> new CommandCell());
    list.setPlaceholder(messages.label("commands-none"));
    Label examples = messages.label("commands-examples", "muted");
    examples.setWrapText(true);
    getChildren().addAll(field, list, examples);
  }

  private void setupEventHandlers() {
    field.textProperty().addListener((property, before, now) -> search());
    field
        .focusedProperty()
        .subscribe(
            focused -> {
              if (focused) {
                Platform.runLater(field::end); // or what was typed already would be selected
              }
            });
    addEventFilter(KeyEvent.KEY_PRESSED, this::press);
    list.addEventHandler(
        MouseEvent.MOUSE_CLICKED,
        click -> {
          if (list.getSelectionModel().getSelectedItem() != null) {
            run();
          }
        });
  }

  private void search() {
    list.getItems().setAll(commands.find(field.getText()));
    list.getSelectionModel().selectFirst();
    list.scrollTo(0);
  }

  private void press(KeyEvent event) {
    switch (event.getCode()) {
      case UP -> select(-1);
      case DOWN -> select(1);
      case ENTER -> run();
      case ESCAPE -> close.run();
      default -> {
        return;
      }
    }
    event.consume();
  }

  private void select(int step) {
    int count = list.getItems().size();
    if (count > 0) {
      int next = Math.floorMod(list.getSelectionModel().getSelectedIndex() + step, count);
      list.getSelectionModel().select(next);
      list.scrollTo(Math.max(0, next - 4));
    }
  }

  /** Closed first: what it does may open something else, or take the focus. */
  private void run() {
    WindowCommand chosen = list.getSelectionModel().getSelectedItem();
    if (chosen != null) {
      close.run();
      chosen.action().run();
    }
  }

  /** A command with its group and its key. */
  private final class CommandCell extends ListCell<WindowCommand> {

    private final Label title = new Label();
    private final Label group = new Label();
    private final Label key = new Label();
    private final HBox parts = new HBox(title, group, key);

    CommandCell() {
      parts.getStyleClass().add("command-row");
      group.getStyleClass().add("muted");
      key.getStyleClass().add("key-name");
      key.setMinWidth(USE_PREF_SIZE);
      key.managedProperty().bind(key.visibleProperty());
      title.setMaxWidth(Double.MAX_VALUE);
      HBox.setHgrow(title, Priority.ALWAYS);
      setPrefWidth(0); // never wider than the list
    }

    @Override
    protected void updateItem(WindowCommand command, boolean empty) {
      super.updateItem(command, empty);
      if (empty || command == null) {
        setGraphic(null);
        setAccessibleText(null);
        return;
      }
      String symbols = command.key().map(known -> known.symbols(messages)).orElse("");
      title.setText(command.title().getValue());
      group.setText(messages.now(command.group().textKey()));
      key.setText(symbols);
      key.setVisible(!symbols.isEmpty());
      setAccessibleText((command.title().getValue() + " " + symbols).strip());
      setGraphic(parts);
    }
  }
}
