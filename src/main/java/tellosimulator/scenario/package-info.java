/**
 * Scenario files: YAML to records and back.
 *
 * <p>{@link tellosimulator.scenario.ScenarioFile} reads a {@link tellosimulator.scenario.Scenario}
 * or says with a {@link tellosimulator.scenario.ScenarioException} all that is wrong with the file,
 * and where; it also writes one. Each key is declared once, as a {@code Field} of a {@code
 * RecordCodec}: how it is read, written, limited and described to editors. {@link
 * tellosimulator.scenario.ScenarioDocument} keeps the text, and changes only what differs: both
 * scenarios become nodes with all keys, and a {@code ScenarioPatch} carries their differences over
 * to the places that a {@code SyntaxTree} knows. {@link tellosimulator.scenario.Gallery} holds the
 * scenarios that come with the program. Everything is immutable and for any thread. The package
 * imports {@code goal} and {@code network} and what these stand on. Running a scenario and judging
 * a flight are not its job.
 */
package tellosimulator.scenario;
