/* Samples, and how likely what was found of them is. */
#ifndef FROND_STATISTICS_CASE_H
#define FROND_STATISTICS_CASE_H

enum { SAMPLE_MAX = 64 };

struct sample {
    double values[SAMPLE_MAX];
    int count;
};

void sample_add(struct sample *sample, double value);
double sample_mean(const struct sample *sample);
double sample_variance(const struct sample *sample); /* of what it is taken from: over count - 1 */
double sample_error(const struct sample *sample);    /* standard error of the mean */

/* Of chi-square as great as this or greater (Q(freedom / 2, chi / 2), the incomplete gamma function). */
double chance_of_chi_square(double chi, double freedom);
/* Of a Student's t as far from 0, on both sides (I_x(freedom / 2, 1 / 2), the incomplete beta function). */
double chance_of_t(double t, double freedom);
/* That two samples of whatever variances have one mean: Welch's t. */
double chance_of_same_mean(const struct sample *a, const struct sample *b);
/* That a sample and the mean of `others` values from elsewhere, of the same variance and rounded to within `rounded`,
 * have one mean. */
double chance_of_mean(const struct sample *sample, double mean, int others, double rounded);

#endif
