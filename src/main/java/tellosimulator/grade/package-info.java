/**
 * Grades the programs of a class: flies each hand-in on the courses of an assignment, and collects
 * the results. {@link tellosimulator.grade.Grader} flies, on threads of its own; {@link
 * tellosimulator.grade.Grades} is the result, which is written and read as JSON and CSV. Flights
 * are processes of the package {@code launcher}. Judging a flight is not its job: the points are
 * those of the scenario.
 */
package tellosimulator.grade;
